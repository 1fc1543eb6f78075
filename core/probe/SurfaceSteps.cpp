#include "core/probe/SurfaceSteps.h"

#include "core/render/FrameInputs.h"

#include <glm/common.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace taa {

namespace {

constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();
constexpr float kDepthTolerance = 0.01f;

bool isInside(const glm::ivec2& sizePx, const glm::dvec2& positionPx) {
  return positionPx.x >= 0.0 && positionPx.y >= 0.0 && positionPx.x < sizePx.x && positionPx.y < sizePx.y;
}

template <typename Visit>
void visitAround(const glm::ivec2& sizePx, int x, int y, Visit visit) {
  for (int row = std::max(0, y - 1); row <= std::min(sizePx.y - 1, y + 1); ++row)
    for (int column = std::max(0, x - 1); column <= std::min(sizePx.x - 1, x + 1); ++column)
      visit(column, row);
}

glm::ivec2 seenSize(const SeenSurfaces& seen) {
  return {seen.objectId.width, seen.objectId.height};
}

/// A value at a pixel of the frame.
float valueOf(const Image SeenSurfaces::*image, const SeenSurfaces& seen, int x, int y) {
  return *(seen.*image).at(x - seen.corner.x, y - seen.corner.y);
}

/// Where the surface of a pixel was a frame ago, px; nothing: off the picture, or nowhere.
std::optional<glm::dvec2> formerPlace(const SeenSurfaces& now, int x, int y, const glm::ivec2& sizePx) {
  const float* motion = now.motionPx.at(x - now.corner.x, y - now.corner.y);
  const glm::dvec2 place(x + 0.5 - motion[0], y + 0.5 - motion[1]);
  if (motion[0] == kNoPreviousPosition || !isInside(sizePx, place)) return {};
  return place;
}

bool wasSeen(const SeenSurfaces& before, const glm::dvec2& placePx, float object, float depthView,
             const glm::ivec2& sizePx) {
  float least = std::numeric_limits<float>::infinity(), most = -least;
  visitAround(sizePx, static_cast<int>(placePx.x), static_cast<int>(placePx.y), [&](int x, int y) {
    if (valueOf(&SeenSurfaces::objectId, before, x, y) != object) return;
    const float depth = valueOf(&SeenSurfaces::depthView, before, x, y);
    least = std::min(least, depth);
    most = std::max(most, depth);
  });
  return depthView >= least * (1.0f - kDepthTolerance) && depthView <= most * (1.0f + kDepthTolerance);
}

glm::vec4 valuesAt(const Image& image, int x, int y) {
  return image.texel(x, y);
}
glm::vec4 valuesAt(const twin::Texels& texels, int x, int y) {
  return texels.texel(x, y);
}

template <typename Steps>
std::optional<glm::dvec2> foundStep(const Steps& steps, const glm::dvec2& positionPx, float object) {
  const auto column = static_cast<int>(positionPx.x), row = static_cast<int>(positionPx.y);
  glm::vec4 found = valuesAt(steps, column, row);
  double nearest = std::numeric_limits<double>::infinity();
  if (found.z != object)
    visitAround({steps.width, steps.height}, column, row, [&](int x, int y) {
      const double dx = x + 0.5 - positionPx.x, dy = y + 0.5 - positionPx.y;
      const double distance = dx * dx + dy * dy;
      if (distance >= nearest || valuesAt(steps, x, y).z != object) return;
      nearest = distance;
      found = valuesAt(steps, x, y);
    });
  if (found.z != object || std::isnan(found.x)) return {};
  return glm::dvec2(found.x, found.y);
}

} // namespace

Image surfaceSteps(const SeenSurfaces& now, const SeenSurfaces& before) {
  assert(seenSize(now) == seenSize(before));
  const glm::ivec2 sizePx = seenSize(now);
  return surfaceSteps(now, before, {0, 0, sizePx.x, sizePx.y}, sizePx);
}

Image surfaceSteps(const SeenSurfaces& now, const SeenSurfaces& before, const gl::Rect& part,
                   const glm::ivec2& sizePx) {
  Image steps(part.width, part.height, kStepChannels);
  for (int row = 0; row < part.height; ++row)
    for (int column = 0; column < part.width; ++column) {
      const int x = part.x + column, y = part.y + row;
      const float object = valueOf(&SeenSurfaces::objectId, now, x, y);
      const std::optional<glm::dvec2> place = formerPlace(now, x, y, sizePx);
      const bool isKnown = place && wasSeen(before, *place, object,
                                            valueOf(&SeenSurfaces::previousDepthView, now, x, y), sizePx);
      const float* motion = now.motionPx.at(x - now.corner.x, y - now.corner.y);
      float* step = steps.at(column, row);
      step[0] = isKnown ? motion[0] : kNothing;
      step[1] = isKnown ? motion[1] : kNothing;
      step[2] = object;
      step[3] = maskFlags(now, x, y);
      if (isKnown && valueOf(&SeenSurfaces::objectId, before, static_cast<int>(place->x),
                             static_cast<int>(place->y)) != object)
        step[3] += static_cast<float>(StepFlag::SeenBeside);
    }
  return steps;
}

float maskFlags(const SeenSurfaces& seen, int x, int y) {
  if (seen.mask.empty()) return 0.0f;
  const float* mask = seen.mask.at(x - seen.corner.x, y - seen.corner.y);
  return (mask[0] > 0.0f ? static_cast<float>(StepFlag::BlendedOver) : 0.0f) +
         (mask[1] > 0.0f ? static_cast<float>(StepFlag::Changes) : 0.0f);
}

gl::Rect formerPlaces(const SeenSurfaces& now, const gl::Rect& part, const glm::ivec2& sizePx) {
  glm::ivec2 low = sizePx, high(-1);
  for (int y = part.y; y < part.y + part.height; ++y)
    for (int x = part.x; x < part.x + part.width; ++x)
      if (const auto place = formerPlace(now, x, y, sizePx)) {
        low = glm::min(low, glm::ivec2(*place) - 1);
        high = glm::max(high, glm::ivec2(*place) + 1);
      }
  low = glm::max(low, glm::ivec2(0));
  high = glm::min(high, sizePx - 1);
  return high.x < low.x ? gl::Rect{} : gl::Rect{low.x, low.y, high.x - low.x + 1, high.y - low.y + 1};
}

std::vector<glm::vec4> stepsAround(const twin::Texels& steps, const glm::ivec2& pixel) {
  std::vector<glm::vec4> around;
  visitAround({steps.width, steps.height}, pixel.x, pixel.y,
              [&](int x, int y) { around.push_back(steps.texel(x, y)); });
  return around;
}

std::optional<glm::dvec2> stepAt(const Image& steps, const glm::dvec2& positionPx, float object) {
  return foundStep(steps, positionPx, object);
}

std::optional<glm::dvec2> stepAt(const twin::Texels& steps, const glm::dvec2& positionPx, float object) {
  return foundStep(steps, positionPx, object);
}

} // namespace taa
