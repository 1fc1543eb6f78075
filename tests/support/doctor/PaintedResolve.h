// What a resolve makes of painted frames: a tenth of each and nine tenths of what the pixel's own motion
// leads to, the frame alone where that lies beyond the picture; with mistakes.
#pragma once

#include "core/doctor/frames/DoctorFrame.h"
#include "tests/support/doctor/PaintedFrames.h"

#include <vector>

namespace taa::test {

struct PaintedResolve {
  float alpha = 0.1f;
  float motionFactor = 1.0f; ///< history is read at p − factor · motion
  bool isSwapped = true;     ///< false: history is the output of the frame before the last
  bool resetsAtCuts = true;
  float alphaBefore = 0.1f; ///< α before `wrongFrom`
  int wrongFrom = 0;        ///< before that frame history is read where it lies, from the frame before
  int cut = -1;             ///< a frame that states one, from which on another picture is seen; below 0: none
  int nanFrame = -1;        ///< in which one pixel of the output is no number; below 0: none
};

/// Frames with color and output, from frame 0 on. Motion of the shot in whole pixels is resolved exactly.
std::vector<doctor::DoctorFrame> resolvedFrames(const PaintedShot& shot, int frames,
                                                const PaintedResolve& resolve);

} // namespace taa::test
