// Where regions lie in a frame, by the middle of their pixels.
#pragma once

#include "core/doctor/frames/Regions.h"

#include <glm/vec2.hpp>

#include <vector>

namespace taa::doctor {

struct RegionMiddle {
  double count = 0.0;  ///< pixels
  glm::dvec2 sum{0.0}; ///< of their places, px; row 0 is the top
  bool isCut = false;  ///< by the picture's border

  glm::dvec2 place() const { return sum / count; }
};

/// By region; those that are not there have no pixels.
std::vector<RegionMiddle> centroidsOf(const std::vector<RegionIndex>& labels, const glm::ivec2& sizePx);

} // namespace taa::doctor
