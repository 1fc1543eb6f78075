// Draws the frames that views are compared with, beside the one on show.
#pragma once

#include "core/jobs/context/Job.h"
#include "core/jobs/context/Subscriptions.h"
#include "core/jobs/context/Transport.h"
#include "core/requests/Requests.h"

#include <cstdint>
#include <vector>

namespace taa {

class Comparing final : public Job {
 public:
  Comparing(JobContext& jobContext, const Transport& transport, const Subscriptions& subscriptions)
      : jobContext_(jobContext), transport_(transport), subscriptions_(subscriptions) {}

  void take(const request::Cancel&) { stop(); }
  void take(const request::SetViews&);

  bool isDue() override;
  void step() override;

 private:
  std::vector<int> frames() const;
  void stop();

  JobContext& jobContext_;
  const Transport& transport_;
  const Subscriptions& subscriptions_;
  std::uint64_t stoppedAt_ = 0; // version for which `stopped_` were cancelled or failed: not again
  std::vector<int> stopped_;    // frames
};

} // namespace taa
