// Where the samples of the reference lie in the pixel.
#pragma once

#include <glm/vec2.hpp>

namespace taa {

/// Displacement of image content for sample `index` (from 0), px within ±½: the first N points are the first
/// of 2N, each pair has the mean 0, and they fill the square evenly (R2 of Roberts 2018, from its middle
/// outwards).
glm::vec2 referencePointPx(int index);

} // namespace taa
