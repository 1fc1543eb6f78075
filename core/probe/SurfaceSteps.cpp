#include "core/probe/SurfaceSteps.h"

#include "core/render/FrameInputs.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace taa {

namespace {

constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();
constexpr float kDepthTolerance = 0.01f;

bool isInside(const Image& image, const glm::dvec2& positionPx) {
  return positionPx.x >= 0.0 && positionPx.y >= 0.0 && positionPx.x < image.width &&
         positionPx.y < image.height;
}

template <typename Visit>
void visitAround(const Image& image, int x, int y, Visit visit) {
  for (int row = std::max(0, y - 1); row <= std::min(image.height - 1, y + 1); ++row)
    for (int column = std::max(0, x - 1); column <= std::min(image.width - 1, x + 1); ++column)
      visit(column, row);
}

bool wasSeen(const SeenSurfaces& before, const glm::dvec2& placePx, float object, float depthView) {
  float least = std::numeric_limits<float>::infinity(), most = -least;
  visitAround(before.objectId, static_cast<int>(placePx.x), static_cast<int>(placePx.y), [&](int x, int y) {
    if (*before.objectId.at(x, y) != object) return;
    least = std::min(least, *before.depthView.at(x, y));
    most = std::max(most, *before.depthView.at(x, y));
  });
  return depthView >= least * (1.0f - kDepthTolerance) && depthView <= most * (1.0f + kDepthTolerance);
}

} // namespace

Image surfaceSteps(const SeenSurfaces& now, const SeenSurfaces& before) {
  assert(now.objectId.width == before.objectId.width && now.objectId.height == before.objectId.height);
  Image steps(now.objectId.width, now.objectId.height, kStepChannels);
  for (int y = 0; y < steps.height; ++y)
    for (int x = 0; x < steps.width; ++x) {
      const float* motion = now.motionPx.at(x, y);
      const float object = *now.objectId.at(x, y);
      const glm::dvec2 place(x + 0.5 - motion[0], y + 0.5 - motion[1]);
      const bool isKnown = motion[0] != kNoPreviousPosition && isInside(steps, place) &&
                           wasSeen(before, place, object, *now.previousDepthView.at(x, y));
      float* step = steps.at(x, y);
      step[0] = isKnown ? motion[0] : kNothing;
      step[1] = isKnown ? motion[1] : kNothing;
      step[2] = object;
      step[3] = isKnown && *before.objectId.at(static_cast<int>(place.x), static_cast<int>(place.y)) != object
                    ? 1.0f
                    : 0.0f;
    }
  return steps;
}

std::optional<glm::dvec2> stepAt(const Image& steps, const glm::dvec2& positionPx, float object) {
  const auto column = static_cast<int>(positionPx.x), row = static_cast<int>(positionPx.y);
  const float* found = steps.at(column, row);
  double nearest = std::numeric_limits<double>::infinity();
  if (found[2] != object)
    visitAround(steps, column, row, [&](int x, int y) {
      const double dx = x + 0.5 - positionPx.x, dy = y + 0.5 - positionPx.y;
      const double distance = dx * dx + dy * dy;
      if (steps.at(x, y)[2] != object || distance >= nearest) return;
      nearest = distance;
      found = steps.at(x, y);
    });
  if (found[2] != object || std::isnan(found[0])) return {};
  return glm::dvec2(found[0], found[1]);
}

} // namespace taa
