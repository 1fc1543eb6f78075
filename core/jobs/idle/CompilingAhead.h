// Compiles what settings need that somebody looks at and may take.
#pragma once

#include "core/jobs/context/Job.h"
#include "core/jobs/context/Transport.h"
#include "core/requests/Requests.h"

#include <optional>

namespace taa {

class CompilingAhead final : public Job {
 public:
  CompilingAhead(JobContext& jobContext, const Transport& transport)
      : jobContext_(jobContext), transport_(transport) {}

  void take(const request::Prepare& subscriptions);
  void take(const request::SetSettings&) { prepared_.reset(); } // it came too late

  bool isDue() override { return prepared_ && jobContext_.isOpen() && !transport_.isPlaying(); }
  void step() override;

 private:
  JobContext& jobContext_;
  const Transport& transport_;
  std::optional<Settings> prepared_;
};

} // namespace taa
