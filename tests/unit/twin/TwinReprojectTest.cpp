// Dilation and reprojection of the CPU twin (invariants 20, 21, 23, 25).
#include "tests/support/frames/TwinInputs.h"

#include "core/taa/twin/Stages.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace taa::twin {
namespace {

using test::constantInputs;

constexpr DilateSettings kClosest{DilateMethod::Closest3x3};

// Techniques: 4.1.
TEST(TwinDilate, SpreadsTheForegroundsMotionByOnePixel) {
  Inputs inputs = constantInputs(9, 5, glm::vec3(0.5f));
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 4; ++x) { // a half-plane in front of the background moves
      inputs.depth.at(x, y)[0] = 0.5f;
      inputs.motion.at(x, y)[0] = 3.0f;
    }
  }
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 9; ++x) {
      const DilatedMotion dilated = dilateMotion(inputs, kClosest, {x, y});
      EXPECT_EQ(dilated.motion, glm::vec2(x <= 4 ? 3.0f : 0.0f, 0.0f)) << x << ", " << y;
      EXPECT_EQ(dilated.depth, x <= 4 ? 0.5f : 0.1f);
      EXPECT_EQ(dilateMotion(inputs, {DilateMethod::None}, {x, y}).motion.x, x < 4 ? 3.0f : 0.0f);
    }
  }
}

TEST(TwinDilate, KeepsThePixelItselfAmongEqualsAndInTheSky) {
  for (const float depth : {0.0f, 0.25f}) {
    Inputs inputs = constantInputs(3, 3, glm::vec3(0.5f));
    for (float& value : inputs.depth.pixels) value = depth;
    for (int x = 0; x < 3; ++x) {
      EXPECT_EQ(dilateMotion(inputs, kClosest, {x, 1}).offset, glm::ivec2(0));
    }
  }
}

TEST(TwinDilate, TakesTheFirstOfEquallyNearNeighborsAndStaysInThePicture) {
  Inputs inputs = constantInputs(3, 3, glm::vec3(0.5f));
  inputs.depth.at(2, 0)[0] = 0.5f;
  inputs.depth.at(0, 2)[0] = 0.5f;
  EXPECT_EQ(dilateMotion(inputs, kClosest, {1, 1}).offset, glm::ivec2(1, -1)); // rows first
  EXPECT_EQ(dilateMotion(inputs, kClosest, {2, 0}).offset, glm::ivec2(0));
  EXPECT_EQ(dilateMotion(inputs, kClosest, {0, 1}).offset, glm::ivec2(0, 1));
}

// Manual §26, D13: with each tap the depth of the next one is kept, and step() holds for equal depths:
// from the first that is no farther than the pixel on, each is compared with itself, and the last of them
// wins.
// Techniques: D13.
TEST(TwinDilate, AsHdrpPrintsItTheLowerLeftWinsWhereAnyIsNoFarther) {
  const auto chosen = [](const std::array<float, 4>& depths) { // in the order of the comparisons
    Inputs inputs = constantInputs(3, 3, glm::vec3(0.5f));
    inputs.depth.at(1, 1)[0] = 0.1f;
    inputs.depth.at(2, 2)[0] = depths[0];
    inputs.depth.at(0, 0)[0] = depths[1];
    inputs.depth.at(2, 0)[0] = depths[2];
    inputs.depth.at(0, 2)[0] = depths[3];
    return dilateMotion(inputs, {DilateMethod::ClosestXAsPrinted}, {1, 1});
  };
  const DilatedMotion printed = chosen({0.3f, 0.05f, 0.2f, 0.01f}); // the last is the farthest of all
  EXPECT_EQ(printed.offset, glm::ivec2(-1, 1));
  EXPECT_EQ(printed.depth, 0.01f) << "of the texel that was chosen";
  EXPECT_EQ(chosen({0.05f, 0.05f, 0.2f, 0.01f}).offset, glm::ivec2(-1, 1));
  EXPECT_EQ(chosen({0.1f, 0.1f, 0.1f, 0.1f}).offset, glm::ivec2(-1, 1)) << "as near is near enough";
  EXPECT_EQ(chosen({0.05f, 0.05f, 0.05f, 0.05f}).offset, glm::ivec2(0)) << "all are farther";
}

TEST(TwinDilate, GivesViewDepthInMetersAndZeroForTheSky) {
  const Inputs inputs = constantInputs(1, 1, glm::vec3(0.5f));
  EXPECT_EQ(viewDepth(0.1f, inputs.depthTerms), 1.0f);
  EXPECT_EQ(viewDepth(0.05f, inputs.depthTerms), 2.0f);
  EXPECT_EQ(viewDepth(0.0f, inputs.depthTerms), 0.0f);
}

// Techniques: 5.8.
TEST(TwinReproject, SubtractsMotionFromThePixelsCenter) {
  const Inputs inputs = constantInputs(8, 4, glm::vec3(0.5f));
  const Reprojection reprojected = reproject(inputs, {}, {2.25f, -1.5f}, {3, 1});
  EXPECT_EQ(reprojected.position, glm::vec2(1.25f, 3.0f));
  EXPECT_TRUE(reprojected.onScreen);
  EXPECT_FALSE(reprojected.noPrevious);
}

// The buffer of source 000 before it reprojects: what was at this pixel, whatever moved there since.
TEST(TwinReproject, ReadsHistoryInPlaceWhateverMoves) {
  const Inputs inputs = constantInputs(8, 4, glm::vec3(0.5f));
  for (const float motion : {0.0f, 2.25f, -300.0f, std::nanf(""), 65504.0f}) {
    const Reprojection reprojected = reproject(inputs, {ReprojectMethod::InPlace}, {motion, 3.0f}, {3, 1});
    EXPECT_EQ(reprojected.position, glm::vec2(3.5f, 1.5f)) << motion;
    EXPECT_TRUE(reprojected.onScreen && !reprojected.noPrevious) << motion;
  }
  EXPECT_EQ(reproject(inputs, {ReprojectMethod::InPlace}, {3.0f, 4.0f}, {3, 1}).speed, 5.0f);
}

TEST(TwinReproject, CountsTheBorderAsInsideAndNanAsOutside) {
  const Inputs inputs = constantInputs(8, 4, glm::vec3(0.5f));
  EXPECT_TRUE(reproject(inputs, {}, {0.5f, 0.0f}, {0, 0}).onScreen);
  EXPECT_FALSE(reproject(inputs, {}, {0.50001f, 0.0f}, {0, 0}).onScreen);
  EXPECT_TRUE(reproject(inputs, {}, {0.0f, -0.5f}, {0, 3}).onScreen);
  EXPECT_FALSE(reproject(inputs, {}, {0.0f, -0.6f}, {0, 3}).onScreen);
  EXPECT_FALSE(reproject(inputs, {}, {std::nanf(""), 0.0f}, {0, 0}).onScreen);
  EXPECT_TRUE(reproject(inputs, {}, {65504.0f, 65504.0f}, {0, 0}).noPrevious);
}

TEST(TwinReproject, StartsAnewWhereTheHistoryPositionIsOutsideOrNoNumber) {
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float motion : {20.0f, -20.0f, infinity, -infinity, std::nanf(""), 65504.0f}) {
    Inputs inputs = constantInputs(4, 4, {0.25f, 0.5f, 0.75f});
    test::setHistory(inputs, glm::vec3(9.0f), 12.0f);
    inputs.motion.at(1, 1)[0] = motion;
    Settings settings;
    settings.dilate.method = DilateMethod::None;
    const PixelRecord record = resolvePixel(inputs, settings, 1, 1);
    EXPECT_EQ(at(record, IntermediateId::resolved), glm::vec4(0.25f, 0.5f, 0.75f, 0.0f)) << motion;
    EXPECT_EQ(at(record, IntermediateId::historyLength).x, 1.0f);
    EXPECT_EQ(at(record, IntermediateId::rejectReason).x, motion == 65504.0f ? 2.0f : 3.0f);
  }
}

} // namespace
} // namespace taa::twin
