// Follows the camera's motion over the frames before one.
#include "core/render/JitterWay.h"

#include "core/render/FrameClock.h"
#include "core/render/FrameRequest.h"
#include "core/render/View.h"

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace taa {

namespace {

constexpr double kShare = 0.2;          // of the angle, a frame
constexpr std::size_t kLongestWay = 64; // frames of motion that are looked back over

/// Motion across the view, px axes; nothing for one that rests. `before`, `now`: view from world.
std::optional<glm::dvec2> wayBetween(const glm::mat4& before, const glm::mat4& now) {
  // Rotations and positions are floats: what they leave of a camera that goes straight ahead is no way.
  constexpr double kRounding = 0x1p-18; // m, and of the distance from the world's origin
  if (before == now) return {};
  const glm::dvec4 onAxis(0.0, 0.0, -1.0, 1.0);
  const glm::dmat4 worldFromBefore = glm::inverse(glm::dmat4(before));
  const glm::dvec4 seen = glm::dmat4(now) * (worldFromBefore * onAxis);
  const glm::dvec2 way(-seen.x, seen.y); // against what is seen to move; y down
  const double length = glm::length(way);
  if (!(length > kRounding * std::max(1.0, glm::length(glm::dvec3(worldFromBefore[3]))))) return {};
  return way / length;
}

} // namespace

glm::dvec2 turnedTowards(const glm::dvec2& way, const glm::dvec2& goal) {
  const double across = way.x * goal.y - way.y * goal.x + 0.0; // + 0: half a turn is never −π
  const double angle = kShare * std::atan2(across, glm::dot(way, goal));
  const double c = std::cos(angle), s = std::sin(angle);
  return glm::normalize(glm::dvec2(c * way.x - s * way.y, s * way.x + c * way.y));
}

glm::dvec2 jitterWay(const Scene& scene, const FrameRequest& request, int frame) {
  std::vector<glm::dvec2> ways; // the latest first
  glm::mat4 now = cameraOf(scene, request, frame).viewFromWorld;
  for (; !isCut(scene, frame) && ways.size() < kLongestWay; --frame) {
    const glm::mat4 before = cameraOf(scene, request, frame - 1).viewFromWorld;
    if (const auto way = wayBetween(before, now)) ways.push_back(*way);
    now = before;
  }
  glm::dvec2 result = kFirstWay;
  for (auto goal = ways.rbegin(); goal != ways.rend(); ++goal) result = turnedTowards(result, *goal);
  return result;
}

} // namespace taa
