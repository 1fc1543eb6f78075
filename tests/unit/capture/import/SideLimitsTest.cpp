// What a side file states and no capture can is left out, in a sentence, and nothing else is.
#include "core/capture/import/SideLimits.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace taa::capture {

namespace {

constexpr StatedMatrix kMatrix = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

std::vector<CapturedFrame> threeFrames() {
  std::vector<CapturedFrame> frames(3);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    frames[i].view = frames[i].projection = kMatrix;
    frames[i].jitter = {0.25, -0.5};
    frames[i].seconds = 0.5 * static_cast<double>(i);
  }
  return frames;
}

/// What is said of them.
std::vector<std::string> kept(std::vector<CapturedFrame>& frames) {
  std::vector<std::string> unsure;
  keepWithinLimits(frames, "frames.json", unsure);
  return unsure;
}

} // namespace

TEST(SideLimits, WhatCanBeStatedStays) {
  std::vector<CapturedFrame> frames = threeFrames();
  frames[1].view.reset();
  frames[1].projection.reset();
  EXPECT_TRUE(kept(frames).empty()) << "a frame may have no matrices";
  EXPECT_TRUE(frames[0].view && frames[2].projection);
  EXPECT_EQ(frames[2].jitter, glm::dvec2(0.25, -0.5));
  EXPECT_EQ(frames[2].seconds, 1.0);
  std::vector<CapturedFrame> plain(2);
  EXPECT_TRUE(kept(plain).empty());
}

TEST(SideLimits, MatricesStandTogetherAndAreFinite) {
  std::vector<CapturedFrame> frames = threeFrames();
  frames[0].projection.reset();
  frames[2].view.value()[3] = 1e31;
  EXPECT_EQ(kept(frames), std::vector<std::string>{
                              "matrices of 2 of 3 frames in frames.json are not used: a view or a projection "
                              "stands alone, or has numbers that no camera has"});
  EXPECT_FALSE(frames[0].view || frames[2].view || frames[2].projection);
  EXPECT_TRUE(frames[1].view && frames[1].projection);
}

TEST(SideLimits, JitterIsWithinAPicture) {
  std::vector<CapturedFrame> frames = threeFrames();
  frames[1].jitter.y = -1e7;
  EXPECT_EQ(kept(frames), std::vector<std::string>{"the jitter of 1 of 3 frames in frames.json is not used: "
                                                   "it is beyond any picture"});
  EXPECT_EQ(frames[1].jitter, glm::dvec2(0.0));
  EXPECT_EQ(frames[0].jitter, glm::dvec2(0.25, -0.5));
}

TEST(SideLimits, TimesAreThoseOfAllFramesAndRise) {
  const std::vector<std::string> said = {"the times in frames.json are not used: some frames have none, or "
                                         "they do not rise from frame to frame"};
  for (const double wrong : {0.0, -1.0, 1e10, std::numeric_limits<double>::quiet_NaN()}) {
    std::vector<CapturedFrame> frames = threeFrames();
    frames[1].seconds = wrong;
    EXPECT_EQ(kept(frames), said) << wrong;
    EXPECT_FALSE(frames[0].seconds || frames[2].seconds) << wrong;
  }
  std::vector<CapturedFrame> frames = threeFrames();
  frames[0].seconds.reset();
  EXPECT_EQ(kept(frames), said);
}

} // namespace taa::capture
