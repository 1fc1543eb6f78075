// What a pixel truly moves by under each explanation, from hand-made frames.
#include "core/doctor/motion/MotionTrials.h"

#include "tests/support/doctor/PaintedFrames.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <set>
#include <string>

namespace taa::doctor {
namespace {

constexpr glm::ivec2 kOnGround{20, 80};
constexpr glm::vec2 kGiven{2.0f, -3.0f};

class MotionTrialsTest : public testing::Test {
 protected:
  MotionTrialsTest() {
    now.jitterPx = {0.25f, -0.125f};
    before.jitterPx = {-0.5f, 0.375f};
    for (DoctorFrame* frame : {&before, &now, &after}) frame->startsHistory = false;
    set(now, kGiven);
    set(before, {5.0f, 6.0f});
    set(after, {7.0f, 8.0f});
  }

  static void set(DoctorFrame& frame, const glm::vec2& motion) {
    frame.motionPx.at(kOnGround.x, kOnGround.y)[0] = motion.x;
    frame.motionPx.at(kOnGround.x, kOnGround.y)[1] = motion.y;
  }
  static void fill(DoctorFrame& frame, const glm::vec2& motion) {
    for (std::size_t i = 0; i < frame.motionPx.pixels.size(); ++i)
      frame.motionPx.pixels[i] = i % 2 == 0 ? motion.x : motion.y;
  }
  glm::vec2 moved(MotionKind kind, const glm::vec2& factor = glm::vec2(1.0f)) const {
    return trueMotion({kind, factor}, {now, before, &after}, kOnGround).value_or(glm::vec2(99.0f));
  }

  DoctorFrame before = test::paintedFrame({}, 1), now = test::paintedFrame({}, 2),
              after = test::paintedFrame({}, 3);
};

} // namespace

TEST_F(MotionTrialsTest, ChangeTheMotionGiven) {
  EXPECT_EQ(moved(MotionKind::AsGiven), kGiven);
  EXPECT_EQ(moved(MotionKind::Resting), glm::vec2(0.0f));
  EXPECT_EQ(moved(MotionKind::MirroredX), glm::vec2(-2.0f, -3.0f));
  EXPECT_EQ(moved(MotionKind::MirroredY), glm::vec2(2.0f, 3.0f));
  EXPECT_EQ(moved(MotionKind::Opposite), glm::vec2(-2.0f, 3.0f));
  EXPECT_EQ(moved(MotionKind::SwappedAxes), glm::vec2(-3.0f, 2.0f));
  EXPECT_EQ(moved(MotionKind::Scaled, glm::vec2(0.5f)), glm::vec2(1.0f, -1.5f));
  EXPECT_EQ(moved(MotionKind::OtherUnit, {80.0f, -48.0f}), glm::vec2(160.0f, 144.0f));
}

TEST_F(MotionTrialsTest, DecodeTheMotionGiven) {
  const glm::vec2 size(test::kPaintedPx);
  // What a share s of the picture is stored as, taken for px: (½ + ½ s) · size, and sign(s) √|s| · size.
  EXPECT_EQ(moved(MotionKind::Encoded), 2.0f * kGiven - size);
  const glm::vec2 truth(0.04f * size.x, -0.0025f * size.y);
  set(now, {0.2f * size.x, -0.05f * size.y});
  EXPECT_LT(glm::distance(moved(MotionKind::Root), truth), 1e-4f);
}

TEST_F(MotionTrialsTest, TakeOffJitterAsTheTableOfFaultsPutsItIn) {
  // This: v + j; last: v − j'; both: v + j − j'.
  EXPECT_EQ(moved(MotionKind::JitterOfThis), kGiven - now.jitterPx);
  EXPECT_EQ(moved(MotionKind::JitterOfPrevious), kGiven + before.jitterPx);
  EXPECT_EQ(moved(MotionKind::JitterOfBoth), kGiven - now.jitterPx + before.jitterPx);
  EXPECT_EQ(moved(MotionKind::JitterTakenOff), kGiven + now.jitterPx - before.jitterPx);
}

TEST_F(MotionTrialsTest, TakeMotionOfOtherFrames) {
  EXPECT_EQ(moved(MotionKind::FrameLate), glm::vec2(7.0f, 8.0f));
  EXPECT_EQ(moved(MotionKind::FrameEarly), glm::vec2(5.0f, 6.0f));
  const MotionTrial late{MotionKind::FrameLate}, early{MotionKind::FrameEarly};
  EXPECT_FALSE(trueMotion(late, {now, before, nullptr}, kOnGround));
  before.startsHistory = after.startsHistory = true;
  EXPECT_FALSE(trueMotion(late, {now, before, &after}, kOnGround));
  EXPECT_FALSE(trueMotion(early, {now, before, &after}, kOnGround));
}

TEST_F(MotionTrialsTest, TurnByAQuarter) {
  EXPECT_EQ(moved(MotionKind::TurnedLeft), glm::vec2(-kGiven.y, kGiven.x));
  EXPECT_EQ(moved(MotionKind::TurnedRight), glm::vec2(kGiven.y, -kGiven.x));
}

// A pixel of the frame before that leads here says what led here; one that leads elsewhere does not.
TEST_F(MotionTrialsTest, FollowMotionToTheNextFrame) {
  fill(before, glm::vec2(4.0f, -3.0f));
  set(now, glm::vec2(6.0f, -3.0f)); // it speeds up: what it moves by until the frame after
  EXPECT_EQ(moved(MotionKind::Forward), glm::vec2(4.0f, -3.0f));
  fill(before, glm::vec2(kNoPreviousPosition));
  EXPECT_FALSE(trueMotion({MotionKind::Forward}, {now, before, nullptr}, kOnGround));
}

TEST_F(MotionTrialsTest, KnowTheCamerasMotion) {
  const glm::vec2 camera(2.25f, -1.5f); // of the painted shot
  const auto isNear = [](const glm::vec2& a, const glm::vec2& b) { return glm::distance(a, b) < 1e-4f; };
  EXPECT_TRUE(isNear(moved(MotionKind::OfCamera), camera));
  EXPECT_TRUE(isNear(moved(MotionKind::LacksCamera), kGiven + camera));
  EXPECT_TRUE(isNear(moved(MotionKind::CameraTwice), kGiven - camera));
  now.previousClipFromClip.reset();
  EXPECT_FALSE(trueMotion({MotionKind::OfCamera}, {now, before, nullptr}, kOnGround));
}

// The way of an object is 2 px in frame 1, and 0.3 px more in each frame after it: m of frame n is the sum of
// n and n − 1.
TEST_F(MotionTrialsTest, LeaveOfMotionOfTwoFramesThatOfOne) {
  const auto wayPx = [](int n) { return glm::vec2(2.0f + 0.3f * static_cast<float>(n - 1), -1.0f); };
  set(now, wayPx(5) + wayPx(4));
  fill(before, wayPx(4) + wayPx(3));
  EXPECT_LT(glm::distance(moved(MotionKind::TwoFramesOld), wayPx(5)), 1e-5f);
  // What has jumped, or has only just begun, is said to be half of it.
  fill(before, glm::vec2(0.0f));
  EXPECT_EQ(moved(MotionKind::TwoFramesOld), 0.5f * (wayPx(5) + wayPx(4)));
  fill(before, wayPx(4) + wayPx(3));
  before.startsHistory = true;
  EXPECT_EQ(moved(MotionKind::TwoFramesOld), 0.5f * (wayPx(5) + wayPx(4)));
}

TEST_F(MotionTrialsTest, KnowMotionOfTwoFramesOfWhatRestsByTheCamera) {
  const glm::vec2 camera(2.25f, -1.5f); // in both frames
  set(now, 2.0f * camera);
  set(before, glm::vec2(0.0f)); // says nothing then
  EXPECT_LT(glm::distance(moved(MotionKind::TwoFramesOld), camera), 1e-4f);
}

TEST(MotionTrials, HaveNamesOfTheirOwn) {
  std::set<std::string> ids, texts;
  const auto trials = motionTrials({160, 96});
  EXPECT_EQ(trials.front().kind, MotionKind::AsGiven);
  for (const MotionTrial& trial : trials) {
    EXPECT_TRUE(ids.insert(trialId(trial)).second) << trialId(trial);
    EXPECT_TRUE(texts.insert(trialText(trial)).second) << trialText(trial);
  }
  EXPECT_TRUE(ids.contains("scaled:0.5"));
  EXPECT_TRUE(ids.contains("otherUnit:80,-48"));
}

} // namespace taa::doctor
