// Whether two objects lie in one place, so that jitter decides from frame to frame which of them is seen:
// z-fighting.
#pragma once

#include "core/doctor/CaptureInfo.h"
#include "core/doctor/Diagnosis.h"
#include "core/doctor/motion/MotionTrials.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

namespace taa::doctor {

/// Of two objects: places that show the one in a frame and the other one, at the same distance, in the frame
/// before, in areas: at a line where both touch, jitter changes a row of pixels, and no more.
struct FlippedPair {
  std::size_t toFirst = 0, toSecond = 0; ///< pixels of all pairs of frames, by what they show later
  int pairs = 0;                         ///< of frames
  std::size_t most = 0;                  ///< pixels in one frame …
  RegionPlace place;                     ///< … and where those lie; it has no name yet

  bool isFighting() const;
};

/// Over all pairs of frames. Rests on object numbers and depth: without them nothing is counted.
struct CoplanarEvidence {
  std::map<std::pair<std::uint32_t, std::uint32_t>, FlippedPair> objects; ///< the smaller number first
  double pixels = 0.0;                                                    ///< that were looked at

  void add(const FrameNeighbors& frames);
};

/// Adds a finding for all of them.
void tellCoplanar(const CoplanarEvidence& evidence, const CaptureInfo& captureInfo, Diagnosis& out);

} // namespace taa::doctor
