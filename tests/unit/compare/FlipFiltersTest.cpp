// The filters of FLIP against the formulas of the paper.
#include "core/measure/compare/FlipFilters.h"
#include "core/measure/compare/Flip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>

using taa::FilterWeights;
using taa::FlipFilters;

namespace {

constexpr double kPi = std::numbers::pi;

double sum(const FilterWeights& weights) {
  double total = 0.0;
  for (const float weight : weights) total += double(weight);
  return total;
}

float middle(const FilterWeights& weights, std::ptrdiff_t away = 0) {
  return weights[static_cast<std::size_t>(std::ptrdiff_t(weights.size() / 2) + away)];
}

} // namespace

TEST(FlipFilters, ThatWhichIsSeenOfAColorSumsToOne) {
  const FlipFilters filters(taa::kFlipPixelsPerDegree);
  EXPECT_NEAR(sum(filters.achromatic), 1.0, 1e-6);
  EXPECT_NEAR(sum(filters.redGreen), 1.0, 1e-6);
  EXPECT_NEAR(sum(filters.blueYellow) * sum(filters.blueYellow) +
                  sum(filters.blueYellowTail) * sum(filters.blueYellowTail),
              1.0, 1e-6);
}

TEST(FlipFilters, FallOffAsThePaperSays) {
  const FlipFilters filters(taa::kFlipPixelsPerDegree);
  const auto ratio = [](double b, double px) {
    return std::exp(-kPi * kPi * px * px / (taa::kFlipPixelsPerDegree * taa::kFlipPixelsPerDegree) / b);
  };
  EXPECT_NEAR(middle(filters.achromatic, 2) / middle(filters.achromatic), ratio(0.0047, 2.0), 1e-6);
  EXPECT_NEAR(middle(filters.redGreen, -3) / middle(filters.redGreen), ratio(0.0053, 3.0), 1e-6);
  EXPECT_NEAR(middle(filters.blueYellow, 10) / middle(filters.blueYellow), ratio(0.04, 10.0), 1e-6);
  // Of the two-dimensional filter: a √(π/b) of each.
  const double share = std::pow(middle(filters.blueYellowTail) / middle(filters.blueYellow), 2.0);
  EXPECT_NEAR(share, 13.5 * std::sqrt(1 / 0.025) / (34.1 * std::sqrt(1 / 0.04)), 1e-6);
}

TEST(FlipFilters, DetectorsGiveOneForOneAndNothingForAFlatPicture) {
  const FlipFilters filters(taa::kFlipPixelsPerDegree);
  EXPECT_EQ(filters.edge.size(), 19u) << "0.041 degrees are 2.75 px, three of them 9 px";
  for (const FilterWeights& weights : {filters.edge, filters.point}) {
    double above = 0.0, below = 0.0;
    for (const float weight : weights) (weight > 0.0f ? above : below) += double(weight);
    EXPECT_NEAR(above, 1.0, 1e-6);
    EXPECT_NEAR(below, -1.0, 1e-6);
  }
  EXPECT_NEAR(sum(filters.smooth), 1.0, 1e-6);
  EXPECT_EQ(middle(filters.edge), 0.0f);
  EXPECT_LT(middle(filters.point), 0.0f);
  EXPECT_GT(middle(filters.edge, -3), 0.0f) << "brighter to the left is above 0";
}
