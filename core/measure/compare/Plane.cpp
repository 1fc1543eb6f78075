#include "core/measure/compare/Plane.h"

#include "core/taa/twin/Color.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cassert>

namespace taa {

namespace {

using PlaneBlock = std::array<float, static_cast<std::size_t>(kPlaneBlock)>;

constexpr PlaneBlock kNoBase{};

void addWeighted(PlaneBlock& sum, const float* values, const float* base, float weight) {
  for (std::size_t at = 0; at < sum.size(); ++at) sum[at] += weight * (values[at] - base[at]);
}

int filterRadius(const FilterWeights& weights) {
  assert(weights.size() % 2 == 1);
  return static_cast<int>(weights.size() / 2);
}

/// The row with so many more pixels at both ends.
void extendRow(std::vector<float>& extended, const float* row, int width, int radius) {
  const auto left = extended.begin() + radius, end = left + width;
  std::fill(extended.begin(), left, row[0]);
  std::copy_n(row, width, left);
  std::fill(end, extended.end(), row[width - 1]);
}

/// What of a pixel is taken off the pixels around it before they are weighted.
enum class FilterBase { Nothing, Itself };

Plane alongRows(const Plane& plane, const FilterWeights& weights, FilterBase base) {
  const int radius = filterRadius(weights);
  Plane out(plane.width, plane.height);
  std::vector<float> extended(plane.stride + 2 * static_cast<std::size_t>(radius));
  for (int y = 0; y < plane.height; ++y) {
    extendRow(extended, plane.row(y), plane.width, radius);
    for (std::size_t x = 0; x < plane.stride; x += kPlaneBlock) {
      PlaneBlock sum{};
      const float* off = base == FilterBase::Itself ? extended.data() + x + radius : kNoBase.data();
      for (std::size_t k = 0; k < weights.size(); ++k)
        addWeighted(sum, extended.data() + x + k, off, weights[k]);
      std::copy(sum.begin(), sum.end(), out.row(y) + x);
    }
  }
  return out;
}

Plane alongColumns(const Plane& plane, const FilterWeights& weights, FilterBase base) {
  const int radius = filterRadius(weights);
  Plane out(plane.width, plane.height);
  for (int y = 0; y < plane.height; ++y)
    for (std::size_t x = 0; x < plane.stride; x += kPlaneBlock) {
      PlaneBlock sum{};
      const float* off = base == FilterBase::Itself ? plane.row(y) + x : kNoBase.data();
      for (int k = 0; k <= 2 * radius; ++k)
        addWeighted(sum, plane.row(std::clamp(y + k - radius, 0, plane.height - 1)) + x, off,
                    weights[static_cast<std::size_t>(k)]);
      std::copy(sum.begin(), sum.end(), out.row(y) + x);
    }
  return out;
}

} // namespace

Plane filteredAlongRows(const Plane& plane, const FilterWeights& weights) {
  return alongRows(plane, weights, FilterBase::Nothing);
}

Plane filteredAlongColumns(const Plane& plane, const FilterWeights& weights) {
  return alongColumns(plane, weights, FilterBase::Nothing);
}

Plane differencesAlongRows(const Plane& plane, const FilterWeights& weights) {
  return alongRows(plane, weights, FilterBase::Itself);
}

Plane differencesAlongColumns(const Plane& plane, const FilterWeights& weights) {
  return alongColumns(plane, weights, FilterBase::Itself);
}

Plane filtered(const Plane& plane, const FilterWeights& weights) {
  return filteredAlongColumns(filteredAlongRows(plane, weights), weights);
}

Plane lumaOf(const Image& shown) {
  assert(shown.channels >= 3);
  Plane luma(shown.width, shown.height);
  for (int y = 0; y < shown.height; ++y)
    for (int x = 0; x < shown.width; ++x) {
      const float* color = shown.at(x, y);
      luma.row(y)[x] = twin::luma({color[0], color[1], color[2]});
    }
  return luma;
}

Image imageOf(const Plane& plane) {
  Image image(plane.width, plane.height, 1);
  for (int y = 0; y < plane.height; ++y) std::copy_n(plane.row(y), plane.width, image.at(0, y));
  return image;
}

} // namespace taa
