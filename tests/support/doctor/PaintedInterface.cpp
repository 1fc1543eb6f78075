#include "tests/support/doctor/PaintedInterface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace taa::test {

namespace {

constexpr float kGridPx = 8.0f, kLinePx = 2.0f;

/// How much of a px around `at` is a line, with soft sides.
float lineShareAt(float at) {
  const float place = at - kGridPx * std::floor(at / kGridPx);
  return std::max(0.0f, 1.0f - std::abs(place - 0.5f * kGridPx) / kLinePx);
}

} // namespace

void paintInterface(doctor::DoctorFrame& frame, const glm::vec2& movedPx) {
  for (int y = kBarTop; y < kBarBottom; ++y)
    for (int x = 0; x < frame.luma.width; ++x) {
      const glm::vec2 at = glm::vec2(x, y) + 0.5f - movedPx;
      frame.luma.pixels[static_cast<std::size_t>(y) * frame.luma.width + x] =
          0.05f + 0.45f * std::max(lineShareAt(at.x), lineShareAt(at.y));
    }
}

} // namespace taa::test
