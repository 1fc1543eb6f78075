// What one frame adds to the error of its history, and what of that error it takes along. No GL.
//
// With α the share of the current color (per channel, after tone weighting), c the current color, R the
// reference, R' that of the frame before, q the place that history was read at, p the place where the
// pixel's surface truly was, xᵢ and wᵢ the texels of the history's filter around q and what they weigh:
//   error    = out − R
//   aliasing = α·(c − R)                               what this frame's samples are off
//   blur     = (1 − α)·(Σ wᵢ·R'(xᵢ) − R'(p))           what reading between pixels changed
//   lag      = (1 − α)·(R'(p) − R)                     what has changed on the surface since
//   ghost    = (1 − α)·(Σ wᵢ·R'(xᵢ) − R)               instead of both, where history is of something else
// It is of something else where the surface was not seen in the frame before, or only beside p
// (core/probe/SurfaceSteps.h), and where q is more than half a pixel from p along an axis.
//
// R'(p) between pixels is not known: a mean over a pixel there may show more than the means beside it. Of an
// isolated dot or line, at fractions f of a pixel from the next texel and with m = max(f, 1 − f), the nearest
// texel shows m of its height and bilinear interpolation b = m² + (1 − m)² of it along each axis. So R'(p) is
// looked for within ±(1 − bₓ·bᵧ)/(mₓ·mᵧ) ranges of the sixteen texels around p from the bilinear value; at
// the center of a pixel that is its value alone. R'(p) is the value in there that is nearest to R: what
// resampling may explain is no lag.
#pragma once

#include "core/base/Image.h"
#include "core/settings/Settings.h"
#include "core/taa/twin/Texels.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace taa {

/// Pictures of one frame, of one size, scene-linear.
struct PartsInputs {
  Image resolved, reference; ///< three channels
  Image current;             ///< three: filtered
  Image alpha;               ///< one, or three where channels have their own
  // Not read without the reference of the frame before.
  Image historyPosition; ///< px
  Image depthEdge;       ///< 1: history was read by one bilinear tap
  Image steps;           ///< surfaceSteps() from the frame before
};

/// Of one frame; three channels unless said otherwise.
struct FrameErrors {
  Image error;
  Image aliasing;  ///< all of the error where α is 1
  Image resampled; ///< blur, or ghost where history is of something else
  Image lag;
  // Empty without the reference of the frame before, as `resampled` and `lag`.
  Image kept;    ///< 1 − α, as many channels as that has
  Image history; ///< where it was read, px; a HistoryReading; 1 where it is of something else

  bool hasHistory() const { return !history.empty(); }
};

/// The third channel of FrameErrors::history.
enum class HistoryReading : int { None, Filtered, OneTap };

/// `before`: the reference of the frame before; null: none is read, and α counts as 1.
FrameErrors frameErrors(const PartsInputs& now, const Image* before, const HistorySettings& settings);

/// Whether the history read at `positionPx` is of another place than the surface of a pixel, which came from
/// there by `step` (surfaceSteps()).
bool isOfOtherSurface(const float* step, const glm::vec2& positionPx, const glm::ivec2& pixel);

/// R'(p): of what reference `before` may have held at `placePx`, the color that is nearest to `now`.
glm::vec3 formerColor(const Image& before, const glm::vec2& placePx, const glm::vec3& now);
glm::vec3 formerColor(const twin::Texels& before, const glm::vec2& placePx, const glm::vec3& now);

} // namespace taa
