#include "core/measure/compare/Flip.h"

#include "core/measure/compare/FlipFilters.h"

#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace taa {

namespace {

/// Linear Rec. 709 to XYZ relative to white, so that rows sum to 1; columns as glm has them.
glm::dmat3 relativeXyz() {
  const glm::dmat3 xyz(glm::dvec3(10135552.0 / 24577794.0, 2613072.0 / 12288897.0, 1425312.0 / 73733382.0),
                       glm::dvec3(8788810.0 / 24577794.0, 8788810.0 / 12288897.0, 8788810.0 / 73733382.0),
                       glm::dvec3(4435075.0 / 24577794.0, 887015.0 / 12288897.0, 70074185.0 / 73733382.0));
  const glm::dvec3 white = xyz[0] + xyz[1] + xyz[2];
  return {xyz[0] / white, xyz[1] / white, xyz[2] / white};
}

/// The channels that are filtered: YCxCz without scale and offset, which filters whose sum is 1 keep.
constexpr std::size_t kOpponents = 3;
glm::vec3 opponents(const glm::vec3& xyz) {
  return {xyz.y, xyz.x - xyz.y, xyz.y - xyz.z};
}
glm::vec3 fromOpponents(const glm::vec3& c) {
  return {c.x + c.y, c.x, c.x - c.z};
}

float labCurve(float x) {
  constexpr float kDelta = 6.0f / 29.0f;
  return x > kDelta * kDelta * kDelta ? std::cbrt(x) : x / (3.0f * kDelta * kDelta) + 4.0f / 29.0f;
}

/// L*, a*, b* with Hunt's adjustment: colors fade where it is dark.
glm::vec3 huntLab(const glm::vec3& xyz) {
  const glm::vec3 f(labCurve(xyz.x), labCurve(xyz.y), labCurve(xyz.z));
  const float lightness = 116.0f * f.y - 16.0f, share = 0.01f * lightness;
  return {lightness, share * 500.0f * (f.x - f.y), share * 200.0f * (f.y - f.z)};
}

/// HyAB to the power 0.7.
float colorDistance(const glm::vec3& a, const glm::vec3& b) {
  const glm::vec3 off = a - b;
  return std::pow(std::abs(off.x) + std::sqrt(off.y * off.y + off.z * off.z), 0.7f);
}

/// What an eye has of a picture.
struct SeenPicture {
  std::array<Plane, kOpponents> color; ///< filtered; then L*, a*, b*
  Plane edge, point;
};

std::array<Plane, kOpponents> opponentPlanes(const Image& linear, const glm::mat3& toXyz) {
  std::array<Plane, kOpponents> planes;
  for (Plane& plane : planes) plane = Plane(linear.width, linear.height);
  for (int y = 0; y < linear.height; ++y)
    for (int x = 0; x < linear.width; ++x) {
      const float* at = linear.at(x, y);
      const glm::vec3 c = opponents(toXyz * glm::clamp(glm::vec3(at[0], at[1], at[2]), 0.0f, 1.0f));
      for (std::size_t i = 0; i < kOpponents; ++i) planes[i].row(y)[x] = c[static_cast<int>(i)];
    }
  return planes;
}

Plane lengthOf(Plane along, const Plane& across) {
  for (std::size_t at = 0; at < along.values.size(); ++at)
    along.values[at] = std::sqrt(along.values[at] * along.values[at] + across.values[at] * across.values[at]);
  return along;
}

void toHuntLab(std::array<Plane, kOpponents>& planes, const glm::mat3& toXyz, const glm::mat3& toLinear) {
  for (int y = 0; y < planes[0].height; ++y)
    for (int x = 0; x < planes[0].width; ++x) {
      const glm::vec3 c(planes[0].row(y)[x], planes[1].row(y)[x], planes[2].row(y)[x]);
      const glm::vec3 linear = glm::clamp(toLinear * fromOpponents(c), 0.0f, 1.0f);
      const glm::vec3 lab = huntLab(toXyz * linear);
      for (std::size_t i = 0; i < kOpponents; ++i) planes[i].row(y)[x] = lab[static_cast<int>(i)];
    }
}

SeenPicture seen(const Image& linear, const FlipFilters& filters, const glm::mat3& toXyz,
                 const glm::mat3& toLinear) {
  const std::array<Plane, kOpponents> planes = opponentPlanes(linear, toXyz);
  SeenPicture picture;
  picture.color = {filtered(planes[0], filters.achromatic), filtered(planes[1], filters.redGreen),
                   filtered(planes[2], filters.blueYellow)};
  const Plane tail = filtered(planes[2], filters.blueYellowTail);
  for (std::size_t at = 0; at < tail.values.size(); ++at) picture.color[2].values[at] += tail.values[at];
  toHuntLab(picture.color, toXyz, toLinear);

  const Plane smooth = filteredAlongRows(planes[0], filters.smooth);
  const auto feature = [&](const FilterWeights& derivative) {
    return lengthOf(filteredAlongColumns(differencesAlongRows(planes[0], derivative), filters.smooth),
                    differencesAlongColumns(smooth, derivative));
  };
  picture.edge = feature(filters.edge);
  picture.point = feature(filters.point);
  return picture;
}

/// Small and middling differences get most of the scale.
float redistributed(float distance, float largest) {
  constexpr float kMiddle = 0.4f, kLargeShare = 0.95f;
  const float middle = kMiddle * largest;
  if (distance < middle) return kLargeShare / middle * distance;
  return kLargeShare + (distance - middle) / (largest - middle) * (1.0f - kLargeShare);
}

float flipOf(const SeenPicture& a, const SeenPicture& b, float largest, std::size_t at) {
  const auto lab = [at](const SeenPicture& of) {
    return glm::vec3(of.color[0].values[at], of.color[1].values[at], of.color[2].values[at]);
  };
  const float color = redistributed(colorDistance(lab(a), lab(b)), largest);
  const float edge = std::abs(a.edge.values[at] - b.edge.values[at]);
  const float point = std::abs(a.point.values[at] - b.point.values[at]);
  const float feature = std::sqrt(std::max(edge, point) / std::sqrt(2.0f));
  return std::pow(color, 1.0f - feature);
}

} // namespace

int flipReach(double pixelsPerDegree) {
  return FlipFilters(pixelsPerDegree).radius;
}

Image flipMap(const Image& picture, const Image& reference, double pixelsPerDegree) {
  assert(picture.width == reference.width && picture.height == reference.height && !picture.empty());
  assert(picture.channels >= 3 && reference.channels >= 3);
  const FlipFilters filters(pixelsPerDegree);
  const glm::dmat3 exact = relativeXyz();
  const glm::mat3 toXyz(exact), toLinear(glm::inverse(exact));
  const SeenPicture a = seen(picture, filters, toXyz, toLinear),
                    b = seen(reference, filters, toXyz, toLinear);
  const float largest = colorDistance(huntLab(toXyz[1]), huntLab(toXyz[2])); // green and blue
  Image map(picture.width, picture.height, 1);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x)
      *map.at(x, y) = flipOf(a, b, largest, a.edge.stride * static_cast<std::size_t>(y) + x);
  return map;
}

} // namespace taa
