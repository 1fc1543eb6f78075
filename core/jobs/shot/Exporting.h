// Writes ranges of frames into files; everything else waits for it.
#pragma once

#include "core/jobs/desk/Desk.h"
#include "core/jobs/desk/Job.h"
#include "core/requests/Requests.h"

#include <optional>

namespace taa {

class Exporting final : public Job {
 public:
  explicit Exporting(Desk& desk) : desk_(desk) {}

  void take(const request::ExportSequence& wanted) {
    if (desk_.isOpen()) sequence_ = wanted.sequence;
  }
  void take(const request::Cancel&) { sequence_.reset(); } // it has not begun

  bool isDue() override { return sequence_.has_value(); }
  void step() override;

 private:
  Desk& desk_;
  std::optional<SequenceRequest> sequence_;
};

} // namespace taa
