// The worst pixels of a picture: of an error, of a class of verdicts, of a reason to reject. No GL.
#pragma once

#include "core/base/Image.h"

#include <glm/vec2.hpp>

#include <vector>

namespace taa {

/// How bad each pixel is: one channel, above 0 where it counts at all; what is no number does not count.
using Badness = Image;

/// The amount of each value; of several channels the largest.
Badness amounts(const Image& row);
/// That of `weight` in the pixels whose category it is, at least the smallest number there is: so a pixel of
/// the category counts even where nothing is wrong with it. `weight`: one channel.
Badness ofCategory(const Image& categories, int category, const Image& weight);

struct WorstPixel {
  glm::ivec2 pixel{0};
  float badness = 0.0f;
  bool operator==(const WorstPixel&) const = default;
};

/// The `count` worst local maxima (no pixel of the eight around is worse), the worst first, none within
/// `apartPx` of a worse one along both axes. Of equal ones the upper one comes first, then the left one.
std::vector<WorstPixel> worstPixels(const Badness& badness, int count, int apartPx);

} // namespace taa
