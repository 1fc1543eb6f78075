// Frames are called by their place, and by the engine's number where that is another.
#include "core/doctor/FrameNames.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <numeric>
#include <optional>
#include <vector>

namespace taa::doctor {

TEST(FrameNames, SayWhichOfThoseAsked) {
  const std::vector<int> asked{1, 2, 3, 5, 6, 7, 8, 9, 10};
  const FrameNames names;
  EXPECT_EQ(names.of(asked, asked), "all frames");
  EXPECT_EQ(names.of({5}, asked), "frame 5");
  EXPECT_EQ(names.of({3, 5, 6}, asked), "frames 3 to 6") << "4 was not asked";
  EXPECT_EQ(names.of({1, 3, 6}, asked), "frames 1, 3, 6 (3 of 9)");
  EXPECT_EQ(names.of({1, 3, 5, 6, 7, 8, 10}, asked), "frames 1, 3, 5, 6, 7, 8 and 1 more (7 of 9)");
}

TEST(FrameNames, HoldNumbersThatAreNotThePlaces) {
  std::vector<int> numbers(11);
  std::iota(numbers.begin(), numbers.end(), 0);
  EXPECT_EQ(FrameNames(numbers).number(3), std::nullopt);
  EXPECT_EQ(FrameNames(numbers).of(3), "3");
  for (std::size_t place = 5; place < numbers.size(); ++place) numbers[place] += 2; // two are missing
  const FrameNames names(numbers);
  EXPECT_EQ(names.number(3), 3);
  EXPECT_EQ(names.of(7), "7 (number 9)");
  EXPECT_EQ(names.of(3), "3 (number 3)") << "where some have numbers, all have";
  EXPECT_EQ(names.of(99), "99") << "beyond all of them";
  const std::vector<int> asked{1, 2, 3, 5, 6, 7, 8, 9, 10};
  EXPECT_EQ(names.of(asked, asked), "all frames");
  EXPECT_EQ(names.of({6}, asked), "frame 6 (number 8)");
  EXPECT_EQ(names.of({3, 5, 6}, asked), "frames 3 to 6 (numbers 3 to 8)");
  EXPECT_EQ(names.of({1, 3, 6}, asked), "frames 1, 3, 6 (3 of 9; numbers 1, 3, 8)");
}

} // namespace taa::doctor
