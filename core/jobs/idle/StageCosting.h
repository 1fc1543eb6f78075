// Times passes as they are drawn, and measures what each stage's settings cost on the frame on show.
#pragma once

#include "core/jobs/context/Job.h"
#include "core/jobs/context/JobContext.h"
#include "core/requests/Requests.h"

namespace taa {

class StageCosting final : public Job {
 public:
  explicit StageCosting(JobContext& jobContext) : jobContext_(jobContext) {}

  void take(const request::SetProfiling& subscriptions) {
    jobContext_.inspector.profiler().setProfiling(subscriptions.on);
  }
  void take(const request::MeasureStages&) { isMeasuring_ = jobContext_.isOpen(); }
  void take(const request::Cancel&);

  bool isDue() override { return isMeasuring_; }
  void step() override;
  /// The profile of the frame made last.
  void deliver();

 private:
  JobContext& jobContext_;
  bool isMeasuring_ = false;
};

} // namespace taa
