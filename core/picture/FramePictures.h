// Pictures of a captured frame: what was stored, and the frame before brought along its motion. No GL.
#pragma once

#include "core/capture/decode/DecodedFrame.h"
#include "core/picture/Visualizer.h"

namespace taa {

/// With alpha, 0 where there is nothing; without pixels: the frame has no such plane.
struct FramePictures {
  int frame = 0; ///< into Manifest::frames
  Picture color, motion, depth;
  Picture warped;     ///< color of the frame before, read where motion and jitter say; no pixels: none before
  Picture difference; ///< of color and `warped`, as they are seen
};

/// Longest side of a picture, px; larger frames are scaled down.
inline constexpr int kMaxPictureSide = 960;

/// Color and motion of `frame` where it has any; `previous` is the frame before, null: history starts here.
/// Colors are exposed so that all but the brightest of `frame` is within the range of the screen.
FramePictures drawFrame(const capture::DecodedFrame& frame, const capture::DecodedFrame* previous,
                        int maxSide = kMaxPictureSide);

/// Color of `previous` where each pixel of `frame` was, 4 channels, bilinear; alpha 0: it was outside, or
/// nowhere. Empty where either has no color, or their sizes differ.
Image warpedPrevious(const capture::DecodedFrame& frame, const capture::DecodedFrame& previous);

} // namespace taa
