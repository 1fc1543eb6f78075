// What is true of a pixel by the scene's geometry, whatever the resolve says of it.
#pragma once

#include "tests/support/frames/SurfaceOracle.h"

#include <glm/vec2.hpp>

namespace taa::test {

/// What was around the place that history is read from, in the frame before: two and a half pixels to all
/// sides, which is farther than any test and any dilation looks.
enum class Before {
  Same,   ///< nothing but the surface that is followed
  Other,  ///< nothing of it: it was hidden
  Mixed,  ///< both, so that jitter and footprints decide
  Outside ///< not in the picture
};

struct ProbeFacts {
  SeenPoint own;      ///< at the pixel's sample
  SeenPoint followed; ///< the nearest of the 3×3 samples, which dilation follows
  Before before = Before::Mixed;
  bool followsOther = false; ///< that one has another motion
};

ProbeFacts factsOf(const SurfaceOracle& oracle, const glm::ivec2& pixel, const glm::ivec2& sizePx);

} // namespace taa::test
