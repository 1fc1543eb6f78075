// Ranks among numbers whose order is known by hand.
#include "core/base/Median.h"

#include <gtest/gtest.h>

#include <vector>

namespace taa {

TEST(Median, IsTheMiddleOrTheMeanOfBoth) {
  EXPECT_EQ(median({}), 0.0);
  EXPECT_EQ(median({3.0, 9.0, 1.0}), 3.0);
  EXPECT_EQ(median({9.0, 4.0, 1.0, 3.0}), 3.5);
}

TEST(Median, TheUpperOneIsAValueThatIsThere) {
  EXPECT_EQ(upperMedian({7.0}), 7.0);
  EXPECT_EQ(upperMedian({9.0, 4.0, 1.0, 3.0}), 4.0);
}

TEST(Median, APercentileIsTheNearestRank) {
  std::vector<float> values;
  for (int value = 200; value > 0; --value) values.push_back(static_cast<float>(value));
  EXPECT_EQ(percentile(values, 1), 2.0f);
  EXPECT_EQ(percentile(values, 50), 100.0f);
  EXPECT_EQ(percentile(values, 99), 198.0f);
  EXPECT_EQ(percentile(values, 100), 200.0f);
  std::vector<float> one{7.0f};
  EXPECT_EQ(percentile(one, 1), 7.0f);
}

} // namespace taa
