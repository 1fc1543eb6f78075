// Rectangles of texels.
#pragma once

#include <glm/vec2.hpp>

#include <algorithm>

namespace taa::gl {

struct Rect {
  int x = 0, y = 0, width = 0, height = 0; ///< texels, (x, y) the top-left one
  bool operator==(const Rect&) const = default;
};

inline bool contains(const Rect& whole, const Rect& part) {
  return part.x >= whole.x && part.y >= whole.y && part.x + part.width <= whole.x + whole.width &&
         part.y + part.height <= whole.y + whole.height;
}

/// With `border` texels on each side, as far as the picture of `sizePx` goes.
inline Rect grown(const Rect& part, int border, const glm::ivec2& sizePx) {
  const int left = std::max(part.x - border, 0), top = std::max(part.y - border, 0);
  return {left, top, std::min(part.x + part.width + border, sizePx.x) - left,
          std::min(part.y + part.height + border, sizePx.y) - top};
}

/// The smallest that holds both.
inline Rect rectAround(const Rect& a, const Rect& b) {
  const int left = std::min(a.x, b.x), top = std::min(a.y, b.y);
  return {left, top, std::max(a.x + a.width, b.x + b.width) - left,
          std::max(a.y + a.height, b.y + b.height) - top};
}

} // namespace taa::gl
