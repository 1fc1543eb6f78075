#include "tests/support/frames/FogTruth.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace taa::test {

namespace {

/// Whether a point lies in the cone; `along`: how far down its axis.
bool isInside(const PlacedCone& placed, const glm::dvec3& point, double& along) {
  const glm::dvec3 from = point - placed.apex;
  along = glm::dot(from, placed.axis);
  const double share = along / static_cast<double>(placed.cone.length);
  const double radius = static_cast<double>(placed.cone.startRadius) * (1.0 - share) +
                        static_cast<double>(placed.cone.endRadius) * share;
  return share >= 0.0 && share <= 1.0 && glm::length(from - along * placed.axis) <= radius;
}

} // namespace

FogTruth fogTruth(const PlacedCone& placed, const glm::dvec3& origin, const glm::dvec3& direction, double end,
                  int parts) {
  const double reach = glm::length(placed.apex - origin) + 2.0 * static_cast<double>(placed.cone.length) +
                       static_cast<double>(placed.cone.endRadius);
  const double part = std::min(end, reach) / parts;
  const auto density = static_cast<double>(placed.cone.density);
  FogTruth truth;
  for (int i = 0; i < parts; ++i) {
    double along = 0.0;
    if (!isInside(placed, origin + (i + 0.5) * part * direction, along)) continue;
    const double lit =
        1.0 - static_cast<double>(placed.cone.fading) * along / static_cast<double>(placed.cone.length);
    truth.light += density * part * std::exp(-density * truth.length) * lit * glm::dvec3(placed.cone.light);
    truth.length += part;
  }
  truth.opacity = 1.0 - std::exp(-density * truth.length);
  return truth;
}

glm::dvec3 rayThrough(const glm::ivec2& pixel, const glm::ivec2& size) {
  const double up = std::tan(std::acos(-1.0) / 6.0);
  const double x = 2.0 * (pixel.x + 0.5) / size.x - 1.0, y = 1.0 - 2.0 * (pixel.y + 0.5) / size.y;
  return glm::normalize(glm::dvec3(x * up * size.x / size.y, y * up, -1.0));
}

} // namespace taa::test
