// What a captured shot has of its own: its jitter's period, and the settings that have no effect on it.
#include "core/render/CaptureFacts.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstddef>
#include <vector>

namespace taa {
namespace {

/// `frames` of a pattern of `period` that does not repeat within itself.
std::vector<glm::vec2> pattern(int frames, int period) {
  std::vector<glm::vec2> jitterPx;
  for (int frame = 0; frame < frames; ++frame)
    jitterPx.emplace_back(static_cast<float>(frame % period) / static_cast<float>(period), 0.25f);
  return jitterPx;
}

} // namespace

TEST(CaptureFacts, APeriodIsOneThatIsSeenTwice) {
  EXPECT_EQ(periodOf(pattern(16, 8)), 8);
  EXPECT_EQ(periodOf(pattern(19, 8)), 8);
  EXPECT_EQ(periodOf(pattern(15, 8)), 15) << "seen less than twice";
  EXPECT_EQ(periodOf(pattern(5, 1)), 1) << "the same in all frames";
  EXPECT_EQ(periodOf({{0.25f, 0.0f}}), 1);
  EXPECT_EQ(periodOf({}), 1);
}

TEST(CaptureFacts, APeriodHoldsToAThousandthOfAPixel) {
  std::vector<glm::vec2> jitterPx = pattern(16, 8);
  jitterPx[9].y += 0.0009f;
  EXPECT_EQ(periodOf(jitterPx), 8);
  jitterPx[9].y += 0.0009f;
  EXPECT_EQ(periodOf(jitterPx), 16);
}

// The last of as many frames as there may be breaks every period: the worst there is.
TEST(CaptureFacts, APeriodIsLookedForInBoundedTime) {
  std::vector<glm::vec2> jitterPx(100000, glm::vec2(0.25f));
  jitterPx.back() = glm::vec2(0.0f);
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(periodOf(jitterPx), 100000);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
  EXPECT_EQ(periodOf(pattern(2048, 1024)), 1024) << "the longest that settings know";
}

TEST(CaptureFacts, MotionIsAskedForWhereItCanBeMade) {
  CaptureFacts facts;
  facts.renderPx = facts.outputPx = {8, 8};
  Settings settings;
  settings.inputs.motion = MotionSource::CameraFromDepth;
  const Parameter& row = parameter("inputs.motion");
  EXPECT_TRUE(isFixedBy(facts, row));
  EXPECT_EQ(settingsOn(facts, settings).inputs.motion, MotionSource::Objects);
  facts.hasCameraMotion = true;
  EXPECT_FALSE(isFixedBy(facts, row));
  EXPECT_EQ(settingsOn(facts, settings).inputs.motion, MotionSource::CameraFromDepth);
}

TEST(CaptureFacts, FaultsOfWhatIsDrawnAreFixed) {
  CaptureFacts facts;
  facts.renderPx = facts.outputPx = {8, 8};
  Settings settings;
  settings.fault.jitterApplied = 0.0f;
  settings.fault.jitter = JitterFault::Negated;
  settings.fault.previousCamera = CameraFault::OfNow;
  Settings own = settingsOn(facts, settings);
  EXPECT_EQ(own.fault.jitterApplied, 1.0f) << "the pictures are there";
  EXPECT_EQ(own.fault.jitter, JitterFault::Negated) << "what is reported can be wrong";
  EXPECT_EQ(own.fault.previousCamera, CameraFault::None) << "nothing says where the camera was";
  facts.hasCameraMotion = true;
  own = settingsOn(facts, settings);
  EXPECT_EQ(own.fault.previousCamera, CameraFault::OfNow);
  EXPECT_TRUE(isFixedBy(facts, parameter("fault.skyJitter")));
  EXPECT_FALSE(isFixedBy(facts, parameter("fault.motionY")));
}

TEST(CaptureFacts, OnlyPrecisionIsNeverTheCaptures) {
  CaptureFacts facts;
  facts.renderPx = {8, 6};
  facts.outputPx = {16, 12};
  Settings settings;
  settings.inputs.precision = Precision::Full;
  settings.inputs.mask = MaskSource::Opacity;
  settings.history.precision = Precision::Full;
  const Settings own = settingsOn(facts, settings);
  EXPECT_EQ(own.inputs.precision, Precision::Full);
  EXPECT_EQ(own.inputs.mask, Settings{}.inputs.mask);
  EXPECT_EQ(own.inputs.renderScale, 0.5f);
  EXPECT_EQ(own.history.precision, Precision::Full);
  EXPECT_FALSE(isFixedBy(facts, parameter("inputs.precision")));
  EXPECT_TRUE(isFixedBy(facts, parameter("inputs.mask")));
  EXPECT_TRUE(isFixedBy(facts, parameter("jitter.period")));
}

} // namespace taa
