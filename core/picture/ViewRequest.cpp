#include "core/picture/ViewRequest.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace taa {

gl::Rect visiblePixels(const ViewRequest& view, const glm::ivec2& picturePx) {
  const auto edge = [](float position, int size) {
    return static_cast<int>(std::clamp(position, 0.0f, static_cast<float>(size)));
  };
  const glm::vec2 from = view.transform.origin;
  const glm::vec2 to = from + glm::vec2(view.width, view.height) / view.transform.zoom;
  const int left = edge(std::floor(from.x), picturePx.x), top = edge(std::floor(from.y), picturePx.y);
  return {left, top, edge(std::ceil(to.x), picturePx.x) - left, edge(std::ceil(to.y), picturePx.y) - top};
}

ReasonCounts countReasons(const Image& reasons) {
  ReasonCounts counts{};
  for (const float value : reasons.pixels)
    if (const int reason = static_cast<int>(value); reason >= 0 && reason < kReasonCount)
      ++counts[static_cast<std::size_t>(reason)];
  return counts;
}

} // namespace taa
