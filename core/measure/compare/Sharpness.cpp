#include "core/measure/compare/Sharpness.h"

#include "core/measure/compare/Plane.h"

#include <cassert>
#include <cmath>
#include <cstddef>

namespace taa {

namespace {

// Sobel's operators are products: 1 2 1 across, −1 0 1 along.
Plane gradientLength(const Plane& luma) {
  const FilterWeights smooth{0.25f, 0.5f, 0.25f}, slope{-0.5f, 0.0f, 0.5f};
  Plane length = filteredAlongColumns(differencesAlongRows(luma, slope), smooth);
  const Plane down = filteredAlongRows(differencesAlongColumns(luma, slope), smooth);
  for (std::size_t at = 0; at < down.values.size(); ++at)
    length.values[at] = std::hypot(length.values[at], down.values[at]);
  return length;
}

} // namespace

std::optional<double> sharpness(const Image& shown, const Image& reference) {
  assert(shown.width == reference.width && shown.height == reference.height && !shown.empty());
  const Plane is = gradientLength(lumaOf(shown)), should = gradientLength(lumaOf(reference));
  double sum = 0.0, whole = 0.0;
  for (int y = 0; y < should.height; ++y)
    for (int x = 0; x < should.width; ++x)
      if (should.row(y)[x] > kSharpnessEdge) {
        sum += double(is.row(y)[x]);
        whole += double(should.row(y)[x]);
      }
  if (whole == 0.0) return {};
  return sum / whole;
}

} // namespace taa
