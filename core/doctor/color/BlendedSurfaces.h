// Whether what is blended over surfaces has motion of its own, and leaves that of what is behind alone. Rests
// on the mask, which says where something is blended in.
#pragma once

#include "core/doctor/Diagnosis.h"
#include "core/doctor/motion/MotionTrials.h"

#include <cstddef>

namespace taa::doctor {

/// One explanation against the motion given, over pairs of frames in which the two differ.
struct BlendedTrial {
  int pairs = 0, won = 0;          ///< of frames; won: by the explanation
  std::size_t pixels = 0;          ///< of all of them
  double given = 0.0, tried = 0.0; ///< sums of what both leave
  std::size_t most = 0;            ///< pixels in one frame …
  RegionPlace place;               ///< … and where those lie; it has no name yet

  double share(double sum) const { return pixels == 0 ? 0.0 : sum / static_cast<double>(pixels); }
};

/// Over all pairs of frames.
struct BlendedEvidence {
  /// Shapes in the mask are elsewhere than their motion leads: left is the mask at their silhouettes, 0 to 1.
  BlendedTrial shapes;
  /// What is seen through them moves as what rests behind them does, and motion does not: left is luma.
  BlendedTrial behind;
  bool isMaskKnown = false;
  double pixels = 0.0;     ///< that were looked at
  std::size_t blended = 0; ///< of these: something is blended in

  void add(const FrameNeighbors& frames);
};

/// Adds what is wrong or not decided. `isMaskUsed`: the resolve gets the mask, which may stand for motion.
void tellBlended(const BlendedEvidence& evidence, bool isMaskUsed, Diagnosis& out);

} // namespace taa::doctor
