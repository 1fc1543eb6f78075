#include "core/measure/compare/GhostEnergy.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace taa {

namespace {

glm::vec3 colorAt(const Image& image, int x, int y) {
  const float* color = image.nearest(x, y);
  return {color[0], color[1], color[2]};
}

glm::vec3 sampledColor(const Image& image, const glm::vec2& positionPx) {
  return bilinear(positionPx, [&](int x, int y) { return colorAt(image, x, y); });
}

/// The color of the reference's 3×3 box that is nearest to `color`.
glm::vec3 nearestInBox(const Image& reference, int x, int y, const glm::vec3& color) {
  glm::vec3 low = colorAt(reference, x, y), high = low;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const glm::vec3 neighbor = colorAt(reference, x + dx, y + dy);
      low = glm::min(low, neighbor);
      high = glm::max(high, neighbor);
    }
  return glm::clamp(color, low, high);
}

float ghostAt(const GhostInputs& inputs, int x, int y) {
  const float* q = inputs.historyPositionPx.at(x, y);
  const bool isInside =
      q[0] >= 0.0f && q[1] >= 0.0f && q[0] < float(inputs.shown.width) && q[1] < float(inputs.shown.height);
  if (!isInside) return 0.0f;
  const glm::vec3 color = colorAt(inputs.shown, x, y);
  const glm::vec3 nearest = nearestInBox(inputs.reference, x, y, color);
  const glm::vec3 error = color - nearest, way = sampledColor(inputs.shownBefore, {q[0], q[1]}) - nearest;
  const float square = glm::dot(way, way);
  if (square == 0.0f) return 0.0f;
  return std::clamp(glm::dot(error, way) / square, 0.0f, 1.0f) * std::sqrt(square / 3.0f);
}

} // namespace

Image ghostMap(const GhostInputs& inputs) {
  assert(inputs.shown.width == inputs.reference.width && inputs.shown.height == inputs.reference.height);
  assert(inputs.shown.width == inputs.shownBefore.width && inputs.shown.height == inputs.shownBefore.height);
  assert(inputs.shown.width == inputs.historyPositionPx.width && inputs.historyPositionPx.channels == 2);
  Image map(inputs.shown.width, inputs.shown.height, 1);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) *map.at(x, y) = ghostAt(inputs, x, y);
  return map;
}

double ghostEnergy(const Image& map) {
  double sum = 0.0;
  for (const float ghost : map.pixels) sum += double(ghost) * double(ghost);
  return std::sqrt(sum / static_cast<double>(map.pixels.size()));
}

} // namespace taa
