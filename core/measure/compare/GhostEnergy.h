// Ghost energy: the part of the error that is pulled towards what was shown a frame ago. No GL.
//
// Of what a screen is sent: o the output, R the reference, p the output a frame ago, read bilinearly at the
// history position q, from where the resolve took its history.
//   c = o clamped, channel by channel, to the smallest and largest of R in the 3 × 3 pixels around
//   e = o − c          the error that no blur of the reference explains
//   d = p(q) − c       the way from there to what was shown a frame ago
//   ghost = |t d| / √3 with t = clamp(e·d / d·d, 0, 1): the part of e along d
//   ghost energy = √ mean ghost²
// In units of what is shown, and never above RMSE, which is of all of o − R. 0 where q is off the picture.
// One frame back does not tell why: light that is followed too late and an error that stays, such as the
// silhouettes of sharpening, lie towards what was shown as well. What a blur of one pixel could have made
// never counts, so that a faint ghost on a busy background is missed. The parts of the error (core/verdict)
// tell them apart.
#pragma once

#include "core/base/Image.h"

namespace taa {

/// What a ghost is looked for in; the first three have three channels, as a screen is sent them.
struct GhostInputs {
  const Image& shown;
  const Image& reference;
  const Image& shownBefore;       ///< a frame ago
  const Image& historyPositionPx; ///< two channels; what is not finite or off the picture: no history
};

/// The ghost of each pixel, one channel, 0 to 1. All have the same size.
Image ghostMap(const GhostInputs& inputs);

/// Root of the mean square of the map.
double ghostEnergy(const Image& map);

} // namespace taa
