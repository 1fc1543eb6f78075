// How many texture fetches the resolve of a pixel takes, by the settings alone: what the sources weigh
// quality against (manual §25).
#pragma once

#include "core/settings/Settings.h"

namespace taa {

/// Of one pixel at full size, as a GPU with bilinear samplers makes them: a tap of a filter is one, and a
/// texel that several stages read is one. The resolve here mixes the four texels of a tap itself, for the
/// same bits everywhere; its time is measured, not told by this.
struct TextureFetches {
  int color = 0;    ///< of this frame
  int depth = 0;    ///< of this frame, and where its surfaces were
  int motion = 0;   ///< of this frame
  int identity = 0; ///< object, class, normal and masks of this frame
  int history = 0;  ///< of its color
  int surface = 0;  ///< of what else history keeps: N, depth, object, normal, motion, locks
  int output = 0;   ///< of the resolved picture, where it is sharpened or blurred for the screen

  int sum() const { return color + depth + motion + identity + history + surface + output; }
};

/// At most: where a branch decides, the longer one counts.
TextureFetches textureFetches(const Settings& settings);

} // namespace taa
