#include "core/probe/NearParts.h"

#include <algorithm>

namespace taa {

namespace {

int pixelsIn(const gl::Rect& part) {
  return part.width * part.height;
}

} // namespace

bool areNear(const gl::Rect& a, const gl::Rect& b) {
  constexpr int kPixelsOfDraw = 256; // that take as long as what a draw takes however small it is
  return pixelsIn(gl::rectAround(a, b)) <= pixelsIn(a) + pixelsIn(b) + kPixelsOfDraw;
}

std::vector<gl::Rect> nearParts(const std::vector<gl::Rect>& parts) {
  std::vector<gl::Rect> apart;
  for (gl::Rect part : parts) {
    // What it has grown by may be near to others.
    const auto isNear = [&](const gl::Rect& other) { return areNear(part, other); };
    for (auto near = std::ranges::find_if(apart, isNear); near != apart.end();
         near = std::ranges::find_if(apart, isNear)) {
      part = gl::rectAround(part, *near);
      apart.erase(near);
    }
    apart.push_back(part);
  }
  return apart;
}

} // namespace taa
