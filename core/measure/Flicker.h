// Flicker: how much what is shown of a surface changes over the last frames, more than the supersampled
// reference does. No GL.
//
// s_k: the picture of frame n − k as a screen is sent it (exposure 0, clamped to 0…1, sRGB: shownColors()),
// read bilinearly where the surface that the center of the pixel shows in frame n was then. The way there
// leads from frame to frame along the surface's true motion (core/probe/SurfaceSteps.h), without jitter, so
// that it is the same for all settings. It ends before K frames where history starts (frame 0, a cut), off
// the picture, and where something else was in front; F frames of it are used, this one among them.
//   deviation = √ mean over red, green, blue of variance(s_0 … s_{F−1})     the variance of the F values:
//                                                                          mean square − squared mean
//   flicker   = √ max(0, that mean − the same of the reference, on the same way)
// In units of what is shown: 1 from black to white; a pixel that alternates between a and b has |a − b|/2. A
// change that output and reference share is no flicker, nor is one that the output lacks. Both are 0 where
// F = 1: nothing is known there.
#pragma once

#include "core/base/Image.h"
#include "core/base/Progress.h"

#include <optional>
#include <span>

namespace taa {

/// Frames that it is taken over, K: as many as there are jitters before they repeat, unless told otherwise.
inline constexpr int kMinFlickerFrames = 2, kMaxFlickerFrames = 64, kFlickerFrames = 16;

/// One of those frames.
struct FlickerFrame {
  Image shown;              ///< three channels, as a screen is sent them
  Image reference;          ///< the same of the reference
  Image steps;              ///< surfaceSteps() from the frame before; not read of the oldest
  int referenceSamples = 0; ///< 0: there is no reference
};

/// One channel each.
struct FlickerMaps {
  Image deviation;
  Image flicker; ///< empty where a frame has no reference
  Image frames;  ///< F
};

/// Of the first frame; the others are those before it, newest first. Asks `progress` row by row whether to
/// stop.
FlickerMaps flickerMaps(std::span<const FlickerFrame* const> newestFirst, const Progress& progress = {});

/// Mean of a map over the pixels of which at least two frames were used; nothing where there are none.
std::optional<double> meanOverTime(const Image& map, const Image& frames);

} // namespace taa
