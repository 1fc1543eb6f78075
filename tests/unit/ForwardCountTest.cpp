// Where pixels land that go where their surface is now.
#include "core/render/passes/SceneRenderer.h"

#include "core/render/FrameInputs.h"

#include <gtest/gtest.h>

#include <vector>

namespace taa {
namespace {

/// Of a row of pixels, each with its motion since, px to the right.
std::vector<float> landed(const std::vector<float>& motionOn) {
  Image motion(static_cast<int>(motionOn.size()), 1, 2);
  for (int x = 0; x < motion.width; ++x) motion.at(x, 0)[0] = -motionOn[static_cast<std::size_t>(x)];
  return forwardCount(motion).pixels;
}

TEST(ForwardCount, IsOneWhereNothingMoves) {
  EXPECT_EQ(landed({0, 0, 0}), (std::vector<float>{1, 1, 1}));
}

// Two pixels go two to the right over three that rest: two holes behind them, two collisions before them.
TEST(ForwardCount, IsZeroInHolesAndMoreThanOneInCollisions) {
  EXPECT_EQ(landed({0, 2, 2, 0, 0, 0}), (std::vector<float>{1, 0, 0, 2, 2, 1}));
}

// A surface that grows to twice its width leaves every other pixel without one.
TEST(ForwardCount, IsZeroInTheCracksOfWhatComesNearer) {
  EXPECT_EQ(landed({0, 1, 2, 3, 4, 5, 6}), (std::vector<float>{1, 0, 1, 0, 1, 0, 1}));
}

TEST(ForwardCount, TakesThePixelThatHoldsThePlace) {
  EXPECT_EQ(landed({0.4f, 0, 0}), (std::vector<float>{1, 1, 1})) << "x = 0.9";
  EXPECT_EQ(landed({0.6f, 0, 0}), (std::vector<float>{0, 2, 1})) << "x = 1.1";
}

TEST(ForwardCount, LeavesOutWhatLeavesThePictureOrHasNoPlace) {
  EXPECT_EQ(landed({-1, 0, 1}), (std::vector<float>{0, 1, 0}));
  EXPECT_EQ(landed({0, -kNoPreviousPosition, 0}), (std::vector<float>{1, 0, 1}));
}

} // namespace
} // namespace taa
