#include "core/doctor/frames/RegionCentroids.h"

#include <algorithm>
#include <cstddef>

namespace taa::doctor {

std::vector<RegionMiddle> centroidsOf(const std::vector<RegionIndex>& labels, const glm::ivec2& sizePx) {
  const auto highest = std::ranges::max_element(labels);
  std::vector<RegionMiddle> out(highest == labels.end() ? 0 : static_cast<std::size_t>(*highest + 1));
  for (int y = 0; y < sizePx.y; ++y)
    for (int x = 0; x < sizePx.x; ++x) {
      const RegionIndex label = labels[static_cast<std::size_t>(y) * sizePx.x + x];
      if (label == kNoRegion) continue;
      RegionMiddle& middle = out[static_cast<std::size_t>(label)];
      middle.count += 1.0;
      middle.sum += glm::dvec2(x, y);
      middle.isCut = middle.isCut || x == 0 || y == 0 || x + 1 == sizePx.x || y + 1 == sizePx.y;
    }
  return out;
}

} // namespace taa::doctor
