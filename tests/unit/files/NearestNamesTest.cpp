// Which names are spelled most like another.
#include "core/base/NearestNames.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace taa {

TEST(NearestNames, AreThoseOfTheFewestChangedLetters) {
  const std::vector<std::string_view> names = {"kitten", "sitting", "mitten", "rows"};
  EXPECT_EQ(nearestNames("mittens", names, 2), (std::vector<std::string_view>{"mitten", "kitten"}));
  EXPECT_EQ(nearestNames("row", names, 1), std::vector<std::string_view>{"rows"});
  EXPECT_EQ(nearestNames("", names, 9).size(), 4u);
}

TEST(NearestNames, OfEquallyNearOnesTheFirstIsFirst) {
  const std::vector<std::string_view> names = {"ab", "ac"};
  EXPECT_EQ(nearestNames("ad", names, 2), names);
}

// 48 letters of 4 million are compared, or this would take minutes.
TEST(NearestNames, OfALongNameTheBeginningCounts) {
  const std::vector<std::string_view> names(50, "motion.direction");
  EXPECT_EQ(nearestNames(std::string(4'000'000, 'x'), names, 1).size(), 1u);
}

} // namespace taa
