// What each stage of the resolve costs: the difference of programs that end after it and after the one
// before.
//
// Each program sums up and writes what its stages computed, so that the compiler keeps them; the production
// program is the last one and has no trace of this. All are drawn in each round, one right after the other,
// every other round backwards; see stageCosts() for what is made of it.
#pragma once

#include "core/base/Progress.h"
#include "core/gl/PassTimer.h"
#include "core/measure/StageCosts.h"
#include "core/replay/Checkpoints.h"

#include <memory>
#include <vector>

namespace taa {

/// Keeps what it has measured of a frame when it is stopped, and goes on from there.
class StageMeter {
 public:
  explicit StageMeter(gl::TimingMethod method) : method_(method) {}

  /// Throws Cancelled when `progress` says so.
  StageCosts measure(TaaPass& pass, const ResolvedFrame& frame, const Progress& progress);
  void forget(TaaPass& pass);

 private:
  struct Draw {
    std::size_t program = 0;
    bool counts = false; ///< false: only compiles
  };
  void begin(const ResolvedFrame& frame);
  double time(TaaPass& pass, const ResolvedFrame& frame, const Draw& draw);
  StageCosts result(const ResolvedFrame& frame) const;

  gl::TimingMethod method_;
  std::weak_ptr<const History> measured_; // of the frame that is measured; it may end meanwhile
  History target_;
  std::vector<Draw> draws_;
  std::size_t done_ = 0;
  int repeats_ = 1;                        ///< draws a sample: a GPU is done before its clock ticks
  std::vector<std::vector<double>> times_; ///< by program, then round; ms a draw
};

} // namespace taa
