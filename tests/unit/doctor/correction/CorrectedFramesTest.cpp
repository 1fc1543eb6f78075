// Frames with something made right, pixel by pixel.
#include "core/doctor/examination/CorrectedFrames.h"

#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <vector>

namespace taa::doctor {
namespace {

FrameReader paintedReader() {
  return [](int frame) { return test::paintedFrame({}, frame); };
}

std::map<int, glm::vec2> jitterOfPainted(int frames) {
  std::map<int, glm::vec2> out;
  for (int frame = 0; frame < frames; ++frame) out[frame] = test::paintedFrame({}, frame).jitterPx;
  return out;
}

} // namespace

TEST(CorrectedFrames, HaveTheJitterThatPicturesHold) {
  const JitterCorrector corrector = [](int frame) -> std::optional<glm::vec2> {
    if (frame == 4) return {};
    return glm::vec2(0.5f, -0.25f * static_cast<float>(frame));
  };
  const FrameReader read = withJitter(paintedReader(), corrector, 2, true);
  EXPECT_EQ(read(3).jitterPx, glm::vec2(0.5f, -0.75f));
  EXPECT_EQ(read(3).depthJitterPx, read(3).jitterPx);
  EXPECT_FALSE(read(3).startsHistory);
  EXPECT_TRUE(read(4).startsHistory) << "its own is not known";
  EXPECT_TRUE(read(5).startsHistory) << "that of the frame before is not";
  EXPECT_FALSE(read(6).startsHistory);
}

TEST(CorrectedFrames, HaveTheMotionThatAnExplanationMakes) {
  const DoctorFrame given = test::paintedFrame({}, 3);
  const std::map<int, glm::vec2> jitter = jitterOfPainted(6);
  const DoctorFrame both = withMotion(paintedReader(), {MotionKind::JitterOfBoth}, jitter)(3);
  const DoctorFrame mirrored = withMotion(paintedReader(), {MotionKind::MirroredY}, jitter)(3);
  const glm::vec2 was = given.motionAt(80, 60), left = jitter.at(3) - jitter.at(2);
  EXPECT_EQ(both.motionAt(80, 60), was - left);
  EXPECT_EQ(mirrored.motionAt(80, 60), glm::vec2(was.x, -was.y));
}

TEST(CorrectedFrames, KeepMarksOfNoMotion) {
  const FrameReader marked = [](int frame) {
    DoctorFrame out = test::paintedFrame({}, frame);
    out.motionPx.at(5, 5)[0] = kNoPreviousPosition;
    return out;
  };
  EXPECT_EQ(withMotion(marked, {MotionKind::MirroredX}, jitterOfPainted(3))(2).motionPx.at(5, 5)[0],
            kNoPreviousPosition);
}

TEST(CorrectedFrames, HaveTheDepthThatFollowsFromTheStoredOne) {
  const FrameReader stored = [](int frame) {
    DoctorFrame out = test::paintedFrame({}, frame);
    out.depth = Image(4, 1, 1);
    out.depth.pixels = {0.25f, 0.5f, 1.0f, 0.75f};
    out.depthTerms = {0.0f, 0.5f, -1.0f, 0.0f}; // near plane at half a meter, far plane at infinity
    return out;
  };
  const DoctorFrame reversed = withDepth(stored, {RelationKind::Reversed, 1.0, 0.0})(1);
  EXPECT_EQ(reversed.depth.pixels, (std::vector<float>{0.75f, 0.5f, 0.0f, 0.25f}));
  EXPECT_EQ(reversed.depthView.pixels, (std::vector<float>{0.5f / 0.75f, 1.0f, 0.0f, 2.0f}));
  EXPECT_EQ(reversed.previousDepthView.pixels, reversed.depthView.pixels);
  const DoctorFrame linear = withDepth(stored, {RelationKind::Linear, 0.125, 0.0})(1);
  EXPECT_EQ(linear.depth.pixels, (std::vector<float>{0.5f, 0.25f, 0.0f, 0.125f / 0.75f})) << "1 is the sky";
}

TEST(CorrectedFrames, AreMadeOfOneFrameAndItsJitterAlone) {
  EXPECT_TRUE(correctsAlone({MotionKind::Scaled, glm::vec2(2.0f)}));
  EXPECT_TRUE(correctsAlone({MotionKind::JitterOfPrevious}));
  for (const MotionKind kind : {MotionKind::AsGiven, MotionKind::OfCamera, MotionKind::FrameLate,
                                MotionKind::TwoFramesOld, MotionKind::CameraTurned})
    EXPECT_FALSE(correctsAlone({kind}));
}

TEST(CorrectedFrames, HaveNeitherDepthNorCamerasWhereDepthSaysNothing) {
  ASSERT_TRUE(paintedReader()(2).previousClipFromClip);
  const DoctorFrame without = withoutDepth(paintedReader())(2);
  EXPECT_TRUE(without.depth.empty() && without.depthView.empty() && without.previousDepthView.empty());
  EXPECT_FALSE(without.previousClipFromClip);
  EXPECT_FALSE(without.cameras);
  EXPECT_FALSE(without.motionPx.empty());
}

// A picture that is turned upside down before and after moves the other way along y.
TEST(CorrectedFrames, HaveTheMotionOfMatricesTurnedOver) {
  const DoctorFrame given = test::paintedFrame({}, 2), turned = withFlippedMatrices(paintedReader())(2);
  const auto was = cameraMotionPx(given, {80, 60}, 0.0f), is = cameraMotionPx(turned, {80, 35}, 0.0f);
  ASSERT_TRUE(was && is);
  EXPECT_NEAR(is->x, was->x, 1e-4);
  EXPECT_NEAR(is->y, -was->y, 1e-4);
}

} // namespace taa::doctor
