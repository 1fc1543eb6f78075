// Ratios of paired times, worked out by hand.
#include "core/measure/ResolveRatio.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

using taa::CostRatio;

TEST(ResolveRatio, IsTheMedianOfRatiosWithinRounds) {
  // The machine gets ten times as slow half way through: ratios do not see it.
  const std::vector<double> times{1.5, 1.5, 1.5, 1.5, 15, 15, 15, 15}, base{1, 1, 1, 1, 10, 10, 10, 10};
  const CostRatio ratio = taa::costRatio(times, base);
  EXPECT_DOUBLE_EQ(ratio.median, 1.5);
  EXPECT_DOUBLE_EQ(ratio.low, 1.5);
  EXPECT_DOUBLE_EQ(ratio.high, 1.5);
  EXPECT_DOUBLE_EQ(ratio.known(), 1.5);
}

TEST(ResolveRatio, IsOneWhereNoDifferenceIsKnown) {
  const std::vector<double> base(15, 2.0);
  std::vector<double> times;
  for (std::size_t round = 0; round < base.size(); ++round) times.push_back(round % 2 == 0 ? 2.2 : 1.9);
  const CostRatio ratio = taa::costRatio(times, base);
  EXPECT_DOUBLE_EQ(ratio.median, 1.1);
  EXPECT_EQ(ratio.known(), 1.0);
}

TEST(ResolveRatio, IsNotMovedByAnOutlier) {
  const std::vector<double> base(15, 1.0);
  std::vector<double> times(15, 0.5);
  times[3] = 100.0;
  EXPECT_DOUBLE_EQ(taa::costRatio(times, base).known(), 0.5);
}
