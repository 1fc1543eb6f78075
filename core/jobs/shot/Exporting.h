// Writes ranges of frames into files; everything else waits for it.
#pragma once

#include "core/jobs/context/Job.h"
#include "core/jobs/context/JobContext.h"
#include "core/requests/Requests.h"

#include <optional>

namespace taa {

class Exporting final : public Job {
 public:
  explicit Exporting(JobContext& jobContext) : jobContext_(jobContext) {}

  void take(const request::ExportSequence& subscriptions) {
    if (jobContext_.isOpen()) sequence_ = subscriptions.sequence;
  }
  void take(const request::Cancel&) { sequence_.reset(); } // it has not begun

  bool isDue() override { return sequence_.has_value(); }
  void step() override;

 private:
  JobContext& jobContext_;
  std::optional<SequenceRequest> sequence_;
};

} // namespace taa
