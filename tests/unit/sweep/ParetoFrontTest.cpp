// Pareto fronts of hand-made trade-offs.
#include "core/sweep/ParetoFront.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

using taa::TradeOff;

namespace {

std::vector<bool> front(const std::vector<TradeOff>& tradeOffs) {
  return taa::onParetoFront(tradeOffs);
}

TradeOff at(double x, double y) {
  return std::array{x, y};
}

using Is = std::vector<bool>;

} // namespace

TEST(ParetoFront, IsWhatNothingElseBeatsInBoth) {
  EXPECT_EQ(front({at(1, 5), at(2, 3), at(3, 4), at(4, 1), at(5, 1), at(0, 9)}),
            (Is{true, true, false, true, false, true}));
}

TEST(ParetoFront, LeavesOutWhatIsWorseInOneAndNoBetterInTheOther) {
  EXPECT_EQ(front({at(1, 2), at(1, 3), at(2, 2)}), (Is{true, false, false}));
  EXPECT_EQ(front({at(1, 3), at(1, 2)}), (Is{false, true}));
}

TEST(ParetoFront, HoldsEqualOnesTogether) {
  EXPECT_EQ(front({at(1, 2), at(2, 1), at(1, 2)}), (Is{true, true, true}));
}

TEST(ParetoFront, HasNothingOnItThatIsNotKnown) {
  const double nan = std::nan("");
  EXPECT_EQ(front({{}, at(nan, 0), at(0, nan), at(3, 3)}), (Is{false, false, false, true}));
  EXPECT_EQ(front({}), Is{});
}

TEST(ParetoFront, TakesInfinitiesForWhatTheyAre) {
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(front({at(-infinite, 5), at(1, infinite), at(0, 3)}), (Is{true, false, true}));
  EXPECT_EQ(front({at(infinite, infinite)}), Is{true});
}
