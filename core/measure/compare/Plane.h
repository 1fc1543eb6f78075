// One channel of a picture while it is filtered, and filters that are a product of one along rows and one
// along columns. Outside the picture its outermost pixels go on. No GL.
#pragma once

#include "core/base/Image.h"

#include <cstddef>
#include <vector>

namespace taa {

/// Floats a row is filtered in at once: a fixed number of them is what compilers make vectors of.
inline constexpr int kPlaneBlock = 16;

/// Row 0 at the top. Rows are as long as whole blocks; what lies behind `width` is never read as a pixel.
struct Plane {
  int width = 0, height = 0;
  std::size_t stride = 0; ///< floats from row to row
  std::vector<float> values;

  Plane() = default;
  Plane(int width_, int height_)
      : width(width_), height(height_),
        stride(static_cast<std::size_t>((width_ + kPlaneBlock - 1) / kPlaneBlock * kPlaneBlock)),
        values(stride * static_cast<std::size_t>(height_)) {}

  float* row(int y) { return values.data() + stride * static_cast<std::size_t>(y); }
  const float* row(int y) const { return values.data() + stride * static_cast<std::size_t>(y); }
};

/// Weights of a filter: an odd number, the middle one of the pixel itself. Weight k is of the pixel k −
/// middle to the right or below (a correlation, not mirrored).
using FilterWeights = std::vector<float>;

Plane filteredAlongRows(const Plane& plane, const FilterWeights& weights);
Plane filteredAlongColumns(const Plane& plane, const FilterWeights& weights);
/// Of weights whose sum is 0: of what the pixels around one have more than itself, so that it is exactly 0
/// where all are the same.
Plane differencesAlongRows(const Plane& plane, const FilterWeights& weights);
Plane differencesAlongColumns(const Plane& plane, const FilterWeights& weights);
/// The same weights along both.
Plane filtered(const Plane& plane, const FilterWeights& weights);

/// Rec. 709 luma of what a screen is sent, from three channels of it at least (shownColors()).
Plane lumaOf(const Image& shown);

/// One channel, without what lies behind its width.
Image imageOf(const Plane& plane);

} // namespace taa
