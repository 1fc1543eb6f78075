// What is known of paired times, from times made up by hand.
#include "core/measure/PairedTimes.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <vector>

using namespace taa;

TEST(Measured, HasTheRangeOfTheSignTest) {
  std::vector<double> values;
  for (int value = 1; value <= 15; ++value) values.push_back(value);
  // Of 15 coins three or fewer fall on one side with 576 of 32768; four or fewer with 1941.
  const Measured fifteen = measured(values);
  EXPECT_EQ(fifteen.median, 8.0);
  EXPECT_EQ(fifteen.low, 4.0);
  EXPECT_EQ(fifteen.high, 12.0);
  EXPECT_EQ(fifteen.spread(), 4.0);
  values.resize(6); // all on one side: 1 of 64
  EXPECT_EQ(measured(values).low, 1.0);
  EXPECT_EQ(measured(values).high, 6.0);
  EXPECT_EQ(measured(values).median, 3.5);
}

TEST(Measured, OfTooFewKnowsNothing) {
  const Measured five = measured({1.0, 1.0, 1.0, 1.0, 1.0});
  EXPECT_EQ(five.median, 1.0);
  EXPECT_EQ(five.low, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(five.high, std::numeric_limits<double>::infinity());
}

TEST(Measured, IsNotWidenedByOutliers) {
  std::vector<double> values(15, 2.0);
  values[3] = 400.0;
  values[7] = -90.0;
  EXPECT_EQ(measured(values).low, 2.0);
  EXPECT_EQ(measured(values).high, 2.0);
}

TEST(TimeRatio, IsTheMedianOfRatiosWithinRounds) {
  // The machine gets ten times as slow half way through: ratios do not see it.
  const Measured ratio = timeRatio({{1.5, 1.5, 1.5, 1.5, 15, 15, 15, 15}, {1, 1, 1, 1, 10, 10, 10, 10}});
  EXPECT_DOUBLE_EQ(ratio.median, 1.5);
  EXPECT_DOUBLE_EQ(ratio.low, 1.5);
  EXPECT_DOUBLE_EQ(ratio.high, 1.5);
  EXPECT_DOUBLE_EQ(knownRatio(ratio), 1.5);
}

TEST(TimeRatio, IsOneWhereNoDifferenceIsKnown) {
  PairedTimes times{{}, std::vector<double>(15, 2.0)};
  for (std::size_t round = 0; round < times.base.size(); ++round)
    times.own.push_back(round % 2 == 0 ? 2.2 : 1.9);
  const Measured ratio = timeRatio(times);
  EXPECT_DOUBLE_EQ(ratio.median, 1.1);
  EXPECT_EQ(knownRatio(ratio), 1.0);
}

TEST(TimeRatio, IsNotMovedByAnOutlier) {
  PairedTimes times{std::vector<double>(15, 0.5), std::vector<double>(15, 1.0)};
  times.own[3] = 100.0;
  EXPECT_DOUBLE_EQ(knownRatio(timeRatio(times)), 0.5);
}

TEST(TimeDifference, IsTheMedianOfDifferencesWithinRounds) {
  // The machine gets slower from round to round: unpaired, nothing would be known.
  const Measured difference = timeDifference({{3, 13, 23, 33, 43, 53}, {1, 11, 21, 31, 41, 51}});
  EXPECT_EQ(difference.median, 2.0);
  EXPECT_EQ(difference.spread(), 0.0);
}
