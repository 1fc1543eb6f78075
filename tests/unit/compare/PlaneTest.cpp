// Filters along rows and columns against sums written out.
#include "core/measure/compare/Plane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

using taa::FilterWeights;
using taa::Plane;

namespace {

float valueAt(int x, int y) {
  return float((x * 7 + y * 5) % 16) / 16.0f; // exact, and so are its products with quarters
}

Plane planeOf(int width, int height) {
  Plane plane(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) plane.row(y)[x] = valueAt(x, y);
  return plane;
}

const FilterWeights kWeights{0.25f, 0.0f, 0.5f, 0.75f, -0.5f};

} // namespace

// Sizes around that of a block, and smaller than the filter.
TEST(Plane, IsFilteredWithItsOutermostPixelsGoingOn) {
  for (const int width : {1, 3, 15, 16, 17, 40})
    for (const int height : {1, 4, 9}) {
      const Plane rows = filteredAlongRows(planeOf(width, height), kWeights);
      const Plane columns = filteredAlongColumns(planeOf(width, height), kWeights);
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
          float alongRow = 0.0f, alongColumn = 0.0f;
          for (int k = 0; k < 5; ++k) {
            const float weight = kWeights[static_cast<std::size_t>(k)];
            alongRow += weight * valueAt(std::clamp(x + k - 2, 0, width - 1), y);
            alongColumn += weight * valueAt(x, std::clamp(y + k - 2, 0, height - 1));
          }
          ASSERT_EQ(rows.row(y)[x], alongRow) << width << " × " << height << " at " << x << ", " << y;
          ASSERT_EQ(columns.row(y)[x], alongColumn) << width << " × " << height << " at " << x << ", " << y;
        }
    }
}

TEST(Plane, FiltersAlongBothWithTheSameWeights) {
  const Plane plane = planeOf(18, 7);
  const Plane both = filtered(plane, kWeights);
  EXPECT_EQ(both.values, filteredAlongColumns(filteredAlongRows(plane, kWeights), kWeights).values);
}

TEST(Plane, DifferencesAreNothingWhereAllIsTheSame) {
  Plane plane(20, 3);
  std::fill(plane.values.begin(), plane.values.end(), 0.1f);
  const FilterWeights weights{0.3f, -0.7f, 0.4f}; // whose rounded sum is not quite 0
  for (int x = 0; x < 20; ++x) {
    EXPECT_EQ(differencesAlongRows(plane, weights).row(1)[x], 0.0f);
    EXPECT_EQ(differencesAlongColumns(plane, weights).row(1)[x], 0.0f);
  }
  const FilterWeights slope{-0.5f, 0.0f, 0.5f};
  const Plane pattern = planeOf(20, 3);
  EXPECT_EQ(differencesAlongRows(pattern, slope).row(1)[7], 0.5f * (valueAt(8, 1) - valueAt(6, 1)));
  EXPECT_EQ(differencesAlongColumns(pattern, slope).row(1)[7], 0.5f * (valueAt(7, 2) - valueAt(7, 0)));
}

TEST(Plane, LumaIsThatOfRec709) {
  taa::Image image(2, 1, 3);
  image.pixels = {1.0f, 0.0f, 0.0f, 0.25f, 0.5f, 0.75f};
  const Plane luma = taa::lumaOf(image);
  EXPECT_FLOAT_EQ(luma.row(0)[0], 0.2126f);
  EXPECT_FLOAT_EQ(luma.row(0)[1], 0.2126f * 0.25f + 0.7152f * 0.5f + 0.0722f * 0.75f);
  EXPECT_EQ(taa::imageOf(luma).pixels.size(), 2u);
}
