// How two readings of the same frames differ: whether a fault shows in them, and whether two faults make the
// same frames.
#pragma once

#include "core/doctor/frames/DoctorFrame.h"

namespace taa::doctor {

struct ShownDifference {
  int frames = 0; ///< that were compared …
  /// … and those in which jitter, or pixels enough to be a region, differ by what one sees: motion that reads
  /// another light in the frame before, another depth, another light …
  int shown = 0;
  int shownInOutput = 0; ///< … and those whose output does
  // Sums over frames, of planes of their means over pixels.
  double jitterPx = 0.0;
  double motionPx = 0.0;
  double depth = 0.0; ///< |log| of the distance
  double luma = 0.0;
  double output = 0.0; ///< of what a TAA made of the frames, by its green as c/(1 + c)

  /// Expects the same frame with the same planes and size. `before`: the frame before `b`; null: there is none,
  /// and nothing reads motion.
  void add(const DoctorFrame& a, const DoctorFrame& b, const DoctorFrame* before);
  /// What a TAA is given shows what is wrong with it, whatever that makes of it; where it is given the same,
  /// the output does.
  bool shows() const;
  /// Whether each sum is a small share of that of `other`.
  bool isSmallBeside(const ShownDifference& other) const;
};

} // namespace taa::doctor
