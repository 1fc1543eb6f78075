// How two readings of the same frames differ: whether a fault shows in them, and whether two faults make the
// same frames.
#pragma once

#include "core/doctor/frames/DoctorFrame.h"

namespace taa::doctor {

/// A frame, and the one before it as its reader has it; none: nothing is read there.
struct ReadFrame {
  const DoctorFrame& now;
  const DoctorFrame* before = nullptr;
};

struct ShownDifference {
  int frames = 0; ///< that were compared …
  /// … and those in which jitter, or pixels enough to be a region, differ by what one sees: another depth, or
  /// light that contradicts the frame before, read by motion and jitter, where that without the fault does
  /// not …
  int shown = 0;
  int shownInOutput = 0; ///< … and those whose output does
  int lit = 0;           ///< … and those of which more than some pixels have another light
  // Sums over frames, of planes of their means over pixels.
  double jitterPx = 0.0;
  double motionPx = 0.0;
  double depth = 0.0; ///< |log| of the distance
  double luma = 0.0;
  double output = 0.0; ///< of what a TAA made of the frames, by its green as c/(1 + c)

  /// `faulty`, `sound`: the same frame with the same planes and size, with a fault and without.
  void add(const ReadFrame& faulty, const ReadFrame& sound);
  /// What a TAA is given shows what is wrong with it, whatever that makes of it; where it is given the same,
  /// the output does.
  bool shows() const;
  /// Whether each sum is a small share of that of `other`.
  bool isSmallBeside(const ShownDifference& other) const;
};

} // namespace taa::doctor
