// Motion vectors of the renderer against closed forms: invariants 9, 11, 12, 13 and 15.

#include "tests/support/frames/MotionFixture.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace taa {
namespace {

using test::addQuad;
using test::emptyScene;
using test::fromMiddle;
using test::jump;
using test::kHeight;
using test::kP00;
using test::kP11;
using test::kRight;
using test::kUp;
using test::kWidth;

using MotionTest = test::MotionFixture;

glm::vec4 turned(float degrees, const glm::vec3& axis) {
  const glm::quat q = glm::angleAxis(glm::radians(degrees), axis);
  return {q.x, q.y, q.z, q.w};
}

TEST_F(MotionTest, IsExactlyZeroWhereNothingMovesWhateverTheJitter) {
  Scene scene = emptyScene();
  addQuad(scene, {0, 0, 0}, {4, 1, 3}, {0, 4, 1});
  addQuad(scene, {3, -2, -5}, {6, 1, -3}, {2, 4, 1});
  SceneRenderer renderer(std::make_shared<const Scene>(scene));
  FrameInputs inputs;
  for (const MotionSource source : {MotionSource::Objects, MotionSource::CameraFromDepth})
    for (const Precision precision : {Precision::Full, Precision::Half})
      for (int frame = 0; frame < 16; ++frame) {
        FrameRequest asked = request(source);
        asked.inputs.precision = precision;
        renderer.draw(asked, frame, inputs);
        ASSERT_NE(inputs.info.jitterPx, glm::vec2(0.0f));
        for (const float value : inputs.motion.download().pixels) ASSERT_EQ(value, 0.0f) << "frame " << frame;
      }
}

// Techniques: 3.3.
TEST_F(MotionTest, OfATranslatingPlaneIsTheSameEverywhere) {
  Scene scene = emptyScene();
  const int plane = addQuad(scene, {0, 0, 0}, kRight, kUp);
  jump(scene, plane, AnimationPath::Translation, {0, 0, 0, 0}, {0.1f, 0.05f, 0, 0});
  const Image field = motion(scene);
  for (const glm::ivec2 pixel : {glm::ivec2(0, 0), glm::ivec2(160, 90), glm::ivec2(319, 20)}) {
    // 2e-4 px: interpolated clip positions have 24 bits, of 320 px.
    EXPECT_NEAR(field.texel(pixel.x, pixel.y).x, kP00 * kWidth / 2 * 0.1f / 10.0f, 2e-4f);
    EXPECT_NEAR(field.texel(pixel.x, pixel.y).y, -kP11 * kHeight / 2 * 0.05f / 10.0f, 2e-4f) << "y is down";
  }
}

TEST_F(MotionTest, OfTheCameraIsThatOfThePlaneTheOtherWay) {
  Scene scene = emptyScene();
  addQuad(scene, {0, 0, 0}, kRight, kUp);
  jump(scene, 0, AnimationPath::Translation, {0.1f, 0, 10, 0}, {0, 0, 10, 0});
  for (const MotionSource source : {MotionSource::Objects, MotionSource::CameraFromDepth}) {
    const Image field = motion(scene, request(source));
    EXPECT_NEAR(field.texel(30, 40).x, kP00 * kWidth / 2 * 0.1f / 10.0f, 1e-3f);
    EXPECT_NEAR(field.texel(30, 40).y, 0.0f, 1e-3f);
  }
}

TEST_F(MotionTest, OfAnOrthographicPlaneDependsOnTheWidthAlone) {
  Scene scene = emptyScene();
  scene.cameras[0].orthographic = true;
  scene.cameras[0].height = 20.0f * kHeight / kWidth; // 20 wide
  scene.cameras[0].farPlane = 100.0f;
  const int plane = addQuad(scene, {0, 0, 0}, kRight, kUp);
  jump(scene, plane, AnimationPath::Translation, {0, 0, -20, 0}, {0.1f, 0, 0, 0});
  EXPECT_NEAR(motion(scene).texel(100, 50).x, kWidth * 0.1f / 20.0f, 2e-4f);
}

// Techniques: 3.2.
TEST_F(MotionTest, OfAYawIsThatOfTheDirectionsSkyIncluded) {
  const float angle = glm::radians(0.5f);
  for (const bool hasPlane : {false, true}) {
    Scene scene = emptyScene();
    if (hasPlane) addQuad(scene, {0, 0, 0}, 4.0f * kRight, kUp);
    jump(scene, 0, AnimationPath::Rotation, turned(0.0f, {0, 1, 0}), turned(0.5f, {0, 1, 0})); // to the left
    for (const MotionSource source : {MotionSource::Objects, MotionSource::CameraFromDepth}) {
      const FrameInputs inputs = draw(scene, request(source));
      const Image field = inputs.motion.download();
      for (const int x : {0, 40, 160, 280, 319}) {
        // Content at ndc x now was at the smaller angle before: yawing left moves it right.
        const float now = fromMiddle(inputs.info, x, kHeight / 2).x * 2.0f / kWidth;
        const float before = kP00 * std::tan(std::atan(now / kP00) - angle);
        EXPECT_NEAR(field.texel(x, kHeight / 2).x, (now - before) * kWidth / 2, 1e-3f)
            << x << " plane " << hasPlane;
      }
    }
  }
}

TEST_F(MotionTest, OfARollTurnsThePicture) {
  Scene scene = emptyScene();
  const float degrees = 1.0f, angle = glm::radians(degrees);
  jump(scene, 0, AnimationPath::Rotation, turned(0.0f, {0, 0, 1}), turned(degrees, {0, 0, 1}));
  const FrameInputs inputs = draw(scene, request());
  const Image field = inputs.motion.download();
  for (const glm::ivec2 pixel : {glm::ivec2(10, 20), glm::ivec2(300, 100), glm::ivec2(160, 170)}) {
    const glm::vec2 r = fromMiddle(inputs.info, pixel.x, pixel.y);
    // The camera turns left about its back axis, so the picture turns right: with y down, by +angle.
    const glm::vec2 before(std::cos(angle) * r.x + std::sin(angle) * r.y,
                           std::cos(angle) * r.y - std::sin(angle) * r.x);
    EXPECT_NEAR(field.texel(pixel.x, pixel.y).x, r.x - before.x, 1e-3f);
    EXPECT_NEAR(field.texel(pixel.x, pixel.y).y, r.y - before.y, 1e-3f);
    const glm::vec2 v(field.texel(pixel.x, pixel.y));
    EXPECT_NEAR(glm::length(v), 2.0f * glm::length(r) * std::sin(0.5f * angle), 1e-3f);
  }
}

TEST_F(MotionTest, AddsUpOverCameraAndObject) {
  Scene scene = emptyScene();
  const int plane = addQuad(scene, {0, 0, 0}, kRight, kUp);
  jump(scene, plane, AnimationPath::Translation, {0, 0, 0, 0}, {0.1f, 0, 0, 0});
  jump(scene, 0, AnimationPath::Translation, {0, 0, 10, 0}, {0.1f, 0, 10, 0});
  for (const float value : motion(scene).pixels) ASSERT_NEAR(value, 0.0f, 2e-4f) << "they move together";
}

TEST_F(MotionTest, IsMarkedWhereThePointLayBehindThePreviousCamera) {
  Scene scene = emptyScene();
  addQuad(scene, {0, 0, 0}, kRight, kUp);
  jump(scene, 0, AnimationPath::Translation, {0, 0, -5, 0}, {0, 0, 10, 0});
  for (const MotionSource source : {MotionSource::Objects, MotionSource::CameraFromDepth})
    for (const Precision precision : {Precision::Full, Precision::Half}) {
      FrameRequest asked = request(source);
      asked.inputs.precision = precision;
      const FrameInputs inputs = draw(scene, asked);
      EXPECT_EQ(inputs.motion.download().texel(100, 50).x, kNoPreviousPosition);
      EXPECT_EQ(inputs.motion.download().texel(100, 50).y, kNoPreviousPosition);
      EXPECT_EQ(inputs.previousDepth.download().texel(100, 50).x, 0.0f);
    }
}

TEST_F(MotionTest, IsMarkedWhereAnObjectComesOutOfAScaleOfNothing) {
  const auto field = [this](const glm::vec3& scaleBefore) {
    Scene scene = emptyScene();
    const int plane = addQuad(scene, {0, 0, 0}, kRight, kUp);
    jump(scene, plane, AnimationPath::Scale, glm::vec4(scaleBefore, 0), {1, 1, 1, 0});
    return draw(scene, request());
  };
  for (const float nothing : {0.0f, 1e-5f}) {
    const FrameInputs inputs = field(glm::vec3(nothing));
    EXPECT_EQ(inputs.motion.download().texel(100, 50).x, kNoPreviousPosition) << nothing;
    EXPECT_EQ(inputs.previousDepth.download().texel(100, 50).x, 0.0f) << nothing;
  }
  // Flat is not nothing: a board has a place whatever its thickness.
  EXPECT_EQ(field({1, 1, 0}).motion.download().texel(100, 50).x, 0.0f);
}

TEST_F(MotionTest, OfTheSkyIsMarkedAfterTurningRound) {
  Scene scene = emptyScene();
  jump(scene, 0, AnimationPath::Rotation, turned(0.0f, {0, 1, 0}), turned(180.0f, {0, 1, 0}));
  EXPECT_EQ(motion(scene).texel(100, 50).x, kNoPreviousPosition);
}

// Techniques: 3.2.
TEST_F(MotionTest, LeavesTheSkyAloneWhenTheCameraOnlyTravels) {
  Scene scene = emptyScene();
  jump(scene, 0, AnimationPath::Translation, {0, 0, 10, 0}, {5, 1, 3, 0});
  for (const float value : motion(scene).pixels) ASSERT_EQ(value, 0.0f);
}

TEST_F(MotionTest, KnowsHowFarTheSurfaceWas) {
  Scene scene = emptyScene();
  const int plane = addQuad(scene, {0, 0, 0}, kRight, kUp);
  jump(scene, plane, AnimationPath::Translation, {0, 0, -2, 0}, {0, 0, 0, 0});
  EXPECT_FLOAT_EQ(draw(scene, request()).previousDepth.download().texel(100, 50).x, 12.0f);
  // From depth alone, the surface is taken to have stood still.
  const FrameInputs still = draw(scene, request(MotionSource::CameraFromDepth));
  EXPECT_FLOAT_EQ(still.previousDepth.download().texel(100, 50).x, 10.0f);
}

TEST_F(MotionTest, RefersToTheFrameItselfWhereHistoryStarts) {
  Scene scene = emptyScene();
  const int plane = addQuad(scene, {0, 0, 0}, kRight, kUp);
  jump(scene, plane, AnimationPath::Translation, {0, 0, 0, 0}, {0.1f, 0, 0, 0});
  scene.shot.cuts = {1};
  const FrameInputs cut = draw(scene, request(), 1);
  EXPECT_TRUE(cut.info.startsHistory);
  for (const float value : cut.motion.download().pixels) ASSERT_EQ(value, 0.0f);
  const FrameInputs first = draw(scene, request(), 0);
  EXPECT_TRUE(first.info.startsHistory);
  EXPECT_FALSE(draw(scene, request(), 2).info.startsHistory);
}

constexpr MotionSource kCameraSources[] = {MotionSource::CameraFromDepth, MotionSource::RawUv,
                                           MotionSource::JitterDifference, MotionSource::SingleMatrix,
                                           MotionSource::JitterDifferenceAsPrinted};

// Techniques: 3.1a, D5.
TEST_F(MotionTest, OfTheCameraLeaksTheJitterAsEachVariantDoes) {
  Scene scene = emptyScene();
  addQuad(scene, {0, 0, 0}, {4, 1, 3}, {0, 4, 1}); // and sky around it
  SceneRenderer renderer(std::make_shared<const Scene>(scene));
  FrameInputs inputs;
  for (int frame = 1; frame < 6; ++frame) {
    for (const MotionSource source : kCameraSources) {
      renderer.draw(request(source), frame, inputs);
      const glm::vec2 jitter = inputs.info.jitterPx, before(inputs.block.previousJitter);
      ASSERT_NE(jitter, before);
      glm::vec2 expected(0.0f);
      if (source == MotionSource::RawUv) expected = jitter;
      if (source == MotionSource::JitterDifferenceAsPrinted)
        // 2Δj·½ of device coordinates, less half of it, in pixels of the whole width; y the wrong way.
        expected = glm::vec2(jitter.x - before.x, before.y - jitter.y);
      // Exact where both ways are the same arithmetic, else what 32-bit positions leave of 320 px.
      const bool isExact = source == MotionSource::CameraFromDepth || source == MotionSource::SingleMatrix;
      const Image field = inputs.motion.download();
      for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
          for (int axis = 0; axis < 2; ++axis)
            ASSERT_NEAR(field.at(x, y)[axis], expected[axis], isExact ? 0.0f : 1e-3f)
                << "source " << int(source) << " frame " << frame;
    }
  }
}

// Techniques: 3.1a, 3.1b, 3.1c, D18.
TEST_F(MotionTest, OfTheCameraHasTheKnownErrorOfEachVariant) {
  Scene scene = emptyScene();
  addQuad(scene, {0, 0, 0}, kRight, kUp);
  // Going forward, motion at one depth grows from the middle outwards.
  jump(scene, 0, AnimationPath::Translation, {0, 0, 10, 0}, {0.5f, 0.2f, 8, 0});
  const FrameInputs truth = draw(scene, request());
  const Image right = truth.motion.download();
  const glm::vec2 jitter = truth.info.jitterPx;
  const Image subtracted = motion(scene, request(MotionSource::JitterDifference));
  const Image raw = motion(scene, request(MotionSource::RawUv));
  const Image single = motion(scene, request(MotionSource::SingleMatrix));
  float largest = 0.0f;
  for (int y = 20; y < kHeight - 20; ++y)
    for (int x = 20; x < kWidth - 20; ++x)
      for (int axis = 0; axis < 2; ++axis) {
        const float here = right.at(x, y)[axis];
        ASSERT_NEAR(subtracted.at(x, y)[axis], here, 2e-3f);
        ASSERT_NEAR(raw.at(x, y)[axis], here + jitter[axis], 2e-3f);
        // At most the jitter times the change of motion from pixel to pixel, half a pixel on each axis.
        const float gradient = std::abs(right.at(x + 1, y)[axis] - right.at(x - 1, y)[axis]) +
                               std::abs(right.at(x, y + 1)[axis] - right.at(x, y - 1)[axis]);
        const float error = std::abs(single.at(x, y)[axis] - here);
        ASSERT_LE(error, 0.25f * gradient * 1.1f + 1e-3f);
        largest = std::max(largest, error);
      }
  EXPECT_GT(largest, 5e-3f) << "the shortcut has an error to show";
}

// Techniques: 3.1.
TEST_F(MotionTest, IsTheSameFromObjectsAndFromDepthWhenOnlyTheCameraMoves) {
  Scene scene = emptyScene();
  addQuad(scene, {0, 0, 0}, {4, 1, 3}, {0, 4, 1});
  addQuad(scene, {3, -2, -5}, {6, 1, -3}, {2, 4, 1});
  jump(scene, 0, AnimationPath::Translation, {0, 0, 10, 0}, {0.05f, 0.02f, 9.9f, 0});
  const FrameInputs objects = draw(scene, request()),
                    camera = draw(scene, request(MotionSource::CameraFromDepth));
  const Image a = objects.motion.download(), b = camera.motion.download();
  const Image depthA = objects.previousDepth.download(), depthB = camera.previousDepth.download();
  for (std::size_t i = 0; i < a.pixels.size(); ++i) ASSERT_NEAR(a.pixels[i], b.pixels[i], 1e-3f);
  for (std::size_t i = 0; i < depthA.pixels.size(); ++i)
    ASSERT_NEAR(depthA.pixels[i], depthB.pixels[i], 1e-4f);
}

} // namespace
} // namespace taa
