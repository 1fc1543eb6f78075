// Pixels of a picture made from a smaller drawing: where their samples lie, and what these give (manual
// §22).
#pragma once

#include "core/settings/Settings.h"
#include "core/taa/twin/SampleStages.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace taa::twin {

/// Size of what was drawn against that of the picture (manual §22: r).
glm::vec2 renderRatio(const Inputs& inputs);
/// A motion of the inputs, render px, in px of the picture; the mark of no previous position stays.
glm::vec2 pictureMotion(const Inputs& inputs, const glm::vec2& motion);
/// Which sample lies nearest to a pixel of the picture, and where from the pixel's center, render px.
struct Place {
  glm::ivec2 texel{0};
  glm::vec2 offset{0.0f};
  glm::ivec2 still{0}; ///< the texel that holds the center without jitter
};
Place placeOf(const Inputs& inputs, const glm::ivec2& pixel);

/// The samples that a kernel weighs for that pixel, the nearest in the middle; none where it takes that
/// alone.
Taps upsampleTaps(const Inputs& inputs, UpsampleKernel chosen, const Place& place);
/// The color at the center of a pixel from fewer samples (manual §22); speed in px of the picture.
struct CurrentColor {
  glm::vec3 color{0.0f};
  float confidence = 1.0f; ///< κ
};
CurrentColor upsample(const Inputs& inputs, UpsampleKernel chosen, const Place& place, float speed);

} // namespace taa::twin
