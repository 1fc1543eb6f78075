// Pixels of a picture that hang together, side by side.
#pragma once

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace taa::doctor {

/// Those that hang together with `start` by pixels that belong, and are not taken yet. `belongs`: of a pixel
/// in the picture. `taken`: of all pixels, row by row; they are, then.
template <typename Belongs>
std::vector<glm::ivec2> takeConnected(const glm::ivec2& start, const glm::ivec2& sizePx, Belongs belongs,
                                      std::vector<std::uint8_t>& taken) {
  const auto takenAt = [&](const glm::ivec2& pixel) -> std::uint8_t& {
    return taken[static_cast<std::size_t>(pixel.y) * sizePx.x + pixel.x];
  };
  std::vector<glm::ivec2> out{start};
  takenAt(start) = 1;
  for (std::size_t next = 0; next < out.size(); ++next)
    for (const glm::ivec2& step :
         {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)}) {
      const glm::ivec2 pixel = out[next] + step;
      const bool isThere = pixel.x >= 0 && pixel.y >= 0 && pixel.x < sizePx.x && pixel.y < sizePx.y;
      if (!isThere || takenAt(pixel) != 0 || !belongs(pixel)) continue;
      takenAt(pixel) = 1;
      out.push_back(pixel);
    }
  return out;
}

/// Left, top, first beyond right and bottom. Expects some.
inline glm::ivec4 boxAround(const std::vector<glm::ivec2>& pixels) {
  glm::ivec2 low = pixels.front(), high = low;
  for (const glm::ivec2& pixel : pixels) {
    low = glm::min(low, pixel);
    high = glm::max(high, pixel);
  }
  return {low, high + 1};
}

} // namespace taa::doctor
