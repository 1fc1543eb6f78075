// Parts of a picture that are drawn as one, and those that are not.
#include "core/probe/NearParts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

using taa::areNear;
using taa::nearParts;
using taa::gl::Rect;

namespace {

std::vector<Rect> sorted(std::vector<Rect> parts) {
  std::ranges::sort(parts, {}, &Rect::x);
  return parts;
}

} // namespace

TEST(NearParts, AreThoseBetweenWhichLittleLies) {
  EXPECT_TRUE(areNear({0, 0, 8, 8}, {24, 0, 8, 8})) << "256 px around 128, and 128 between them";
  EXPECT_TRUE(areNear({0, 0, 8, 8}, {40, 0, 8, 8})) << "256 between them";
  EXPECT_FALSE(areNear({0, 0, 8, 8}, {41, 0, 8, 8}));
  EXPECT_FALSE(areNear({0, 0, 8, 8}, {20, 20, 8, 8})) << "784 around 128";
  EXPECT_TRUE(areNear({0, 0, 100, 100}, {50, 50, 10, 10})) << "one lies in the other";
}

TEST(NearParts, ArePutTogether) {
  EXPECT_EQ(nearParts({}), std::vector<Rect>{});
  EXPECT_EQ(nearParts({{3, 4, 5, 6}}), (std::vector<Rect>{{3, 4, 5, 6}}));
  EXPECT_EQ(sorted(nearParts({{0, 0, 8, 8}, {200, 0, 8, 8}, {10, 2, 8, 8}})),
            (std::vector<Rect>{{0, 0, 18, 10}, {200, 0, 8, 8}}));
}

// The third lies between the others, which are too far from each other.
TEST(NearParts, AreNearToWhatTheyArePutTogetherWith) {
  const Rect left{0, 0, 8, 8}, right{60, 0, 8, 8}, between{30, 0, 8, 8};
  ASSERT_FALSE(areNear(left, right));
  EXPECT_EQ(nearParts({left, right, between}), (std::vector<Rect>{{0, 0, 68, 8}}));
}

TEST(NearParts, HoldAllOfWhatTheyAreMadeOf) {
  std::vector<Rect> parts;
  for (int number = 0; number < 60; ++number)
    parts.push_back({number * 37 % 400, number * 91 % 200, 1 + number % 7, 1 + number % 5});
  const std::vector<Rect> found = nearParts(parts);
  EXPECT_GT(found.size(), 1u);
  EXPECT_LT(found.size(), parts.size());
  for (const Rect& part : parts)
    EXPECT_TRUE(std::ranges::any_of(found, [&](const Rect& whole) { return contains(whole, part); }));
  for (std::size_t one = 0; one < found.size(); ++one)
    for (std::size_t other = 0; other < one; ++other) EXPECT_FALSE(areNear(found[one], found[other]));
}
