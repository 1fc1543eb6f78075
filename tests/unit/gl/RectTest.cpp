// Rectangles of texels.
#include "core/gl/Rect.h"

#include <gtest/gtest.h>

using taa::gl::Rect;

TEST(Rect, HoldsWhatLiesInIt) {
  const Rect whole{10, 20, 5, 4};
  EXPECT_TRUE(taa::gl::contains(whole, whole));
  EXPECT_TRUE(taa::gl::contains(whole, {14, 23, 1, 1}));
  EXPECT_FALSE(taa::gl::contains(whole, {15, 23, 1, 1}));
  EXPECT_FALSE(taa::gl::contains(whole, {14, 23, 1, 2}));
  EXPECT_FALSE(taa::gl::contains(whole, {9, 20, 2, 1}));
}

TEST(Rect, GrowsAsFarAsThePicture) {
  EXPECT_EQ(taa::gl::grown({10, 20, 5, 4}, 3, {100, 100}), (Rect{7, 17, 11, 10}));
  EXPECT_EQ(taa::gl::grown({1, 20, 5, 4}, 3, {7, 25}), (Rect{0, 17, 7, 8}));
}

TEST(Rect, AroundTwoIsTheSmallestThatHoldsBoth) {
  EXPECT_EQ(taa::gl::rectAround({10, 20, 5, 4}, {2, 22, 3, 9}), (Rect{2, 20, 13, 11}));
  EXPECT_EQ(taa::gl::rectAround({10, 20, 5, 4}, {11, 21, 1, 1}), (Rect{10, 20, 5, 4}));
}
