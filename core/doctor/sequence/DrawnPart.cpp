#include "core/doctor/sequence/DrawnPart.h"

#include "core/doctor/frames/DoctorFrame.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace taa::doctor {

namespace {

/// Of one row or column: pixels with detail that should differ from the frame before, and those that do not.
struct StaleLine {
  int moving = 0, stale = 0;

  void add(std::uint8_t state) {
    moving += state != 0 ? 1 : 0;
    stale += state > 1 ? 1 : 0;
  }
};

/// The first line from which on nearly all that should move does not; as many as there are: none.
int firstStale(const std::vector<StaleLine>& lines) {
  constexpr double kNearlyAllLines = 0.95;
  auto first = static_cast<int>(lines.size());
  for (int line = first - 1; line >= 0; --line) {
    const StaleLine& at = lines[static_cast<std::size_t>(line)];
    if (at.stale < kNearlyAllLines * at.moving) break;
    if (at.moving > 0) first = line;
  }
  return first;
}

} // namespace

std::optional<glm::ivec2> drawnPart(const Image& luma, const Image& motionPx, const Image& before) {
  constexpr double kLeastLeftOut = 0.02, kMostLeftOut = 0.75, kMostStaleInside = 0.05;
  constexpr int kEnoughStale = 200;
  const glm::ivec2 size(luma.width, luma.height);
  if (before.width != size.x || before.height != size.y) return {};
  /// 0: nothing to say; 1: should differ, and does; 2: does not.
  const auto stateOf = [&](int x, int y) -> std::uint8_t {
    const float detail =
        std::abs(*luma.at(x + 1, y) - *luma.at(x - 1, y)) + std::abs(*luma.at(x, y + 1) - *luma.at(x, y - 1));
    const glm::vec2 motion(motionPx.at(x, y)[0], motionPx.at(x, y)[1]);
    if (detail < kDetailLuma || !isMotion(motion) || glm::length(motion) <= kMovesPx) return 0;
    return *luma.at(x, y) == *before.at(x, y) ? 2 : 1;
  };
  std::vector<StaleLine> rows(static_cast<std::size_t>(size.y)), columns(static_cast<std::size_t>(size.x));
  std::vector<std::pair<glm::ivec2, std::uint8_t>> pixels;
  for (int y = 1; y + 1 < size.y; ++y)
    for (int x = 1; x + 1 < size.x; ++x)
      if (const std::uint8_t state = stateOf(x, y); state != 0) {
        columns[static_cast<std::size_t>(x)].add(state);
        rows[static_cast<std::size_t>(y)].add(state);
        pixels.emplace_back(glm::ivec2(x, y), state);
      }
  const glm::ivec2 drawn(firstStale(columns), firstStale(rows));
  StaleLine inside, outside;
  // Beside the edge itself: there what was drawn is the detail.
  constexpr int kEdge = 2;
  for (const auto& [pixel, state] : pixels) {
    if (pixel.x < drawn.x && pixel.y < drawn.y) inside.add(state);
    if (pixel.x >= drawn.x + kEdge || pixel.y >= drawn.y + kEdge) outside.add(state);
  }
  const glm::dvec2 leftOut = 1.0 - glm::dvec2(drawn) / glm::dvec2(size);
  const bool isLeftOut = leftOut.x >= kLeastLeftOut && leftOut.y >= kLeastLeftOut &&
                         leftOut.x <= kMostLeftOut && leftOut.y <= kMostLeftOut;
  if (!isLeftOut || outside.stale < kEnoughStale || inside.stale > kMostStaleInside * inside.moving)
    return {};
  return drawn;
}

} // namespace taa::doctor
