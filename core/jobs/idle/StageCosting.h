// Times passes as they are drawn, and measures what each stage's settings cost on the frame on show.
#pragma once

#include "core/jobs/desk/Desk.h"
#include "core/jobs/desk/Job.h"
#include "core/requests/Requests.h"

namespace taa {

class StageCosting final : public Job {
 public:
  explicit StageCosting(Desk& desk) : desk_(desk) {}

  void take(const request::SetProfiling& wanted) { desk_.inspector.profiler().setProfiling(wanted.on); }
  void take(const request::MeasureStages&) { isMeasuring_ = desk_.isOpen(); }
  void take(const request::Cancel&);

  bool isDue() override { return isMeasuring_; }
  void step() override;
  /// The profile of the frame made last.
  void deliver();

 private:
  Desk& desk_;
  bool isMeasuring_ = false;
};

} // namespace taa
