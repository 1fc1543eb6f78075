// The points of the reference: within the pixel, even, and the same however many follow.
#include "core/render/ReferencePoints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

using taa::referencePointPx;

namespace {

constexpr int kMax = 1024;

std::vector<float> coordinates(int count, int axis) {
  std::vector<float> values;
  for (int index = 0; index < count; ++index) values.push_back(referencePointPx(index)[axis]);
  return values;
}

} // namespace

TEST(ReferencePoints, AreTheseForEver) {
  EXPECT_EQ(referencePointPx(0), glm::vec2(0.377438843f, 0.284920156f));
  EXPECT_EQ(referencePointPx(1), -referencePointPx(0));
  EXPECT_EQ(referencePointPx(2), glm::vec2(0.1323165f, -0.145239562f));
}

TEST(ReferencePoints, LieInThePixelAndAreAllDifferent) {
  std::vector<std::pair<float, float>> seen;
  for (int index = 0; index < kMax; ++index) {
    const glm::vec2 point = referencePointPx(index);
    EXPECT_LE(std::abs(point.x), 0.5f) << index;
    EXPECT_LE(std::abs(point.y), 0.5f) << index;
    seen.emplace_back(point.x, point.y);
  }
  std::ranges::sort(seen);
  EXPECT_TRUE(std::ranges::adjacent_find(seen) == seen.end());
}

TEST(ReferencePoints, HaveTheMeanZeroAfterEachPair) {
  glm::dvec2 sum(0.0);
  for (int index = 0; index < kMax; ++index) {
    sum += glm::dvec2(referencePointPx(index));
    if (index % 2 == 1) {
      EXPECT_EQ(sum, glm::dvec2(0.0)) << index;
    }
  }
}

// What an edge that crosses the pixel anywhere is given, against what it covers: the error falls as 1/N and
// not as 1/√N.
TEST(ReferencePoints, MeasureTheCoverageOfEdges) {
  for (int count = 4; count <= kMax; count *= 4)
    for (int axis = 0; axis < 2; ++axis) {
      const std::vector<float> values = coordinates(count, axis);
      double worst = 0.0;
      for (int step = 0; step <= 200; ++step) {
        const double edge = step / 200.0 - 0.5;
        const auto below = std::ranges::count_if(values, [edge](float value) { return value < edge; });
        worst = std::max(worst, std::abs(static_cast<double>(below) / count - (edge + 0.5)));
      }
      EXPECT_LE(worst, 2.5 / count) << count << " samples, axis " << axis;
    }
}
