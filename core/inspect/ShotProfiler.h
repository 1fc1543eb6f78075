// Where the time of a frame goes: nothing is measured before it is asked for.
#pragma once

#include "core/base/Progress.h"
#include "core/gl/PassTimer.h"
#include "core/measure/Profiler.h"
#include "core/measure/StageCosts.h"

#include <memory>
#include <optional>
#include <vector>

namespace taa {

class ShotPlayer;

class ShotProfiler {
 public:
  ShotProfiler(ShotPlayer& player, gl::TimingMethod method);

  /// Times every pass from now on, or no longer.
  void setProfiling(bool on);
  bool isProfiling() const { return timer_.has_value(); }
  /// The frame made last, with what was looked at of it since; nothing when none was made since the last
  /// call.
  std::optional<FrameProfile> takeProfile();
  /// What each stage's settings cost more than the cheapest ones on the frame on show. Cancelled: keeps what
  /// it has and goes on from there when it is asked again for the same frame.
  StageCosts measureStages(const Progress& progress = {}, int lane = 0);
  /// How much longer the resolve of a lane takes on the frame on show than that of another.
  Measured measureRatio(int lane, int base, const Progress& progress = {});

 private:
  ShotPlayer& player_;
  gl::TimingMethod method_;
  std::optional<gl::PassTimer> timer_;    // while profiling
  int profiled_ = 0;                      // frames that the timer had seen at the last profile
  std::weak_ptr<const History> measured_; // of the frame whose stages are measured; it may end meanwhile
  std::vector<PairedTimes> pairs_;        // of it, as far as they are measured
  PairedMeter meter_;
};

} // namespace taa
