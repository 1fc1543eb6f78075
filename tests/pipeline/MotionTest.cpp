// Motion of the renderer against closed forms (invariants 6, 8, 9, 11 to 13, 15).
#include "tests/support/GlTest.h"
#include "tests/support/TestScenes.h"

#include "core/render/Jitter.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <cmath>
#include <numbers>

namespace taa {
namespace {

using test::drawFrame;
using test::stillRequest;
using test::TestScene;
using test::wrongMotion;

class MotionTest : public test::GlTest {};

constexpr int kWidth = 192; // 16:9, a tenth of the catalogue's 1920
constexpr int kHeight = 108;

/// Sub-pixel precision that 32-bit positions and depth leave at this size.
constexpr double kTolerancePx = 1e-3;

const double kTanHalfFov = std::tan(std::numbers::pi / 6.0);
const double kP00 = kHeight / (kWidth * kTanHalfFov); // 0.974279

/// From a window position to the ray (x, y, −1) in view space.
glm::dvec2 rayAt(double x, double y) {
  return {(2.0 * x / kWidth - 1.0) / kP00, (1.0 - 2.0 * y / kHeight) * kTanHalfFov};
}
glm::dvec2 windowAt(const glm::dvec2& ray) {
  return {(ray.x * kP00 + 1.0) * 0.5 * kWidth, (1.0 - ray.y / kTanHalfFov) * 0.5 * kHeight};
}

TestScene planeScene(float distance) {
  TestScene test;
  test.addSquare({0.0f, 0.0f, -distance}, 100.0f);
  return test;
}

/// Half of the picture a near plane, the other half sky.
TestScene halfPlaneScene() {
  TestScene test;
  test.addSquare({-100.0f, 0.0f, -10.0f}, 100.0f);
  return test;
}

TEST_F(MotionTest, ATranslatingPlaneMovesByItsShareOfThePicture) {
  TestScene test = planeScene(10.0f);
  test.move(1, {0.1f, 0.0f, 0.0f});
  const Image motion = drawFrame(test.scene, stillRequest(kWidth, kHeight), 5).motion.download();
  const double expected = kP00 * kWidth / 2.0 * 0.1 / 10.0;
  EXPECT_NEAR(expected, 0.935307, 1e-6); // invariant 11 at a tenth of its width
  EXPECT_EQ(wrongMotion(motion, kTolerancePx, [=](double, double) { return glm::dvec2(expected, 0.0); }), "");
}

TEST_F(MotionTest, MovingUpIsNegativeY) {
  TestScene test = planeScene(10.0f);
  test.move(1, {0.0f, 0.1f, 0.0f});
  const Image motion = drawFrame(test.scene, stillRequest(kWidth, kHeight), 5).motion.download();
  const double expected = kHeight / 2.0 / kTanHalfFov * 0.1 / 10.0;
  EXPECT_EQ(wrongMotion(motion, kTolerancePx, [=](double, double) { return glm::dvec2(0.0, -expected); }),
            "");
}

TEST_F(MotionTest, InAnOrthographicCameraThePlaneMovesAlikeAtAnyDistance) {
  for (const float distance : {2.0f, 50.0f}) {
    TestScene test = planeScene(distance);
    test.scene.cameras[0].orthographic = true;
    test.scene.cameras[0].height = 20.0f * kHeight / kWidth; // 20 m wide
    test.scene.cameras[0].farPlane = 100.0f;
    TestScene still = test;
    test.move(1, {0.1f, 0.0f, 0.0f});
    still.move(still.cameraNode, {-0.1f, 0.0f, 0.0f});
    const auto expected = [](double, double) { return glm::dvec2(0.1 * kWidth / 20.0, 0.0); };
    FrameRequest request = stillRequest(kWidth, kHeight);
    EXPECT_EQ(wrongMotion(drawFrame(test.scene, request, 5).motion.download(), kTolerancePx, expected), "");
    EXPECT_EQ(wrongMotion(drawFrame(still.scene, request, 5).motion.download(), kTolerancePx, expected), "");
    request.inputs.motion = MotionSource::CameraFromDepth;
    EXPECT_EQ(wrongMotion(drawFrame(still.scene, request, 5).motion.download(), kTolerancePx, expected), "");
  }
}

TEST_F(MotionTest, ACameraThatMovesTheOtherWayGivesTheSame) {
  TestScene test = planeScene(10.0f);
  test.move(test.cameraNode, {-0.1f, 0.0f, 0.0f});
  for (const MotionSource source : {MotionSource::Objects, MotionSource::CameraFromDepth}) {
    FrameRequest request = stillRequest(kWidth, kHeight);
    request.inputs.motion = source;
    const Image motion = drawFrame(test.scene, request, 5).motion.download();
    EXPECT_EQ(wrongMotion(motion, kTolerancePx, [](double, double) { return glm::dvec2(0.935307, 0.0); }),
              "");
  }
}

TEST_F(MotionTest, CameraAndObjectAddUp) {
  const glm::vec3 object(0.07f, -0.02f, 0.05f);
  const glm::vec3 camera(-0.03f, 0.04f, -0.1f);
  TestScene both = halfPlaneScene();
  both.move(1, object);
  both.move(both.cameraNode, camera);
  TestScene alone = halfPlaneScene();
  alone.move(1, object - camera);
  const Image expected = drawFrame(alone.scene, stillRequest(kWidth, kHeight), 4).motion.download();
  const Image motion = drawFrame(both.scene, stillRequest(kWidth, kHeight), 4).motion.download();
  EXPECT_EQ(wrongMotion(motion, kTolerancePx,
                        [&](double x, double y) {
                          const float* v = expected.at(static_cast<int>(x), static_cast<int>(y));
                          return glm::dvec2(v[0], v[1]);
                        }),
            "");
  TestScene together = halfPlaneScene();
  together.move(1, camera);
  together.move(together.cameraNode, camera);
  const Image none = drawFrame(together.scene, stillRequest(kWidth, kHeight), 4).motion.download();
  EXPECT_EQ(wrongMotion(none, kTolerancePx, [](double, double) { return glm::dvec2(0.0); }), "");
}

/// Where a window position was before the camera yawed by θ to the left (invariant 12), motion from there.
glm::dvec2 yawMotion(const glm::dvec2& window, double theta) {
  const glm::dvec2 ray = rayAt(window.x, window.y);
  const double phi = std::atan(ray.x);
  const glm::dvec2 previous(std::tan(phi - theta), ray.y * std::cos(phi) / std::cos(phi - theta));
  return window - windowAt(previous);
}

TEST_F(MotionTest, YawMovesPlaneAndSkyAlikeByTheClosedForm) {
  constexpr double kTheta = std::numbers::pi / 360.0; // ½°
  // The catalogue's numbers, for a point that was at ndc 0, 0.5 and 0.9 of a picture 1920 wide.
  const auto moved = [=](double ndc) {
    return (kP00 * std::tan(std::atan(ndc / kP00) + kTheta) - ndc) * 960.0;
  };
  EXPECT_NEAR(moved(0.0), 8.1623, 5e-5);
  EXPECT_NEAR(moved(0.5), 10.3584, 5e-5);
  EXPECT_NEAR(moved(0.9), 15.2504, 5e-5);
  TestScene test = halfPlaneScene();
  test.turn(test.cameraNode, {0.0f, 1.0f, 0.0f}, static_cast<float>(kTheta));
  for (const MotionSource source : {MotionSource::Objects, MotionSource::CameraFromDepth}) {
    FrameRequest request = stillRequest(kWidth, kHeight);
    request.inputs.motion = source;
    const FrameInputs inputs = drawFrame(test.scene, request, 3);
    const Image id = inputs.objectId.download();
    EXPECT_NE(id.at(0, 50)[0], 0.0f); // both are in the picture
    EXPECT_EQ(id.at(kWidth - 1, 50)[0], 0.0f);
    EXPECT_EQ(wrongMotion(inputs.motion.download(), kTolerancePx,
                          [](double x, double y) {
                            return yawMotion({x, y}, kTheta);
                          }),
              "");
  }
}

TEST_F(MotionTest, JitterShiftsTheFieldWithThePictureAndStaysOutOfTheMotion) {
  constexpr double kTheta = std::numbers::pi / 360.0;
  TestScene test = halfPlaneScene();
  test.turn(test.cameraNode, {0.0f, 1.0f, 0.0f}, static_cast<float>(kTheta));
  FrameRequest request = stillRequest(kWidth, kHeight);
  request.jitter.sequence = JitterSequence::Halton;
  for (int frame = 1; frame < 5; ++frame) {
    const FrameInputs inputs = drawFrame(test.scene, request, frame);
    const glm::dvec2 j(inputs.info.jitterPx);
    EXPECT_NE(j, glm::dvec2(0.0));
    EXPECT_EQ(wrongMotion(inputs.motion.download(), kTolerancePx,
                          [&](double x, double y) { return yawMotion(glm::dvec2(x, y) - j, kTheta); }),
              "");
  }
}

TEST_F(MotionTest, RollTurnsThePictureAboutItsCenter) {
  constexpr double kTheta = std::numbers::pi / 360.0;
  TestScene test = halfPlaneScene();
  test.turn(test.cameraNode, {0.0f, 0.0f, 1.0f}, static_cast<float>(kTheta)); // content turns clockwise
  for (const MotionSource source : {MotionSource::Objects, MotionSource::CameraFromDepth}) {
    FrameRequest request = stillRequest(kWidth, kHeight);
    request.inputs.motion = source;
    const Image motion = drawFrame(test.scene, request, 3).motion.download();
    EXPECT_EQ(wrongMotion(motion, kTolerancePx,
                          [](double x, double y) {
                            const glm::dvec2 r(x - 0.5 * kWidth, y - 0.5 * kHeight); // y down
                            const double c = std::cos(kTheta);
                            const double s = std::sin(kTheta);
                            return r - glm::dvec2(c * r.x + s * r.y, c * r.y - s * r.x);
                          }),
              "");
    const float* corner = motion.at(0, 0);
    const double radius = std::hypot(0.5 * kWidth - 0.5, 0.5 * kHeight - 0.5);
    EXPECT_NEAR(std::hypot(corner[0], corner[1]), 2.0 * radius * std::sin(kTheta / 2.0), kTolerancePx);
  }
}

TEST_F(MotionTest, AStaticSceneHasExactlyNoMotionWhateverTheJitter) {
  TestScene test;
  for (int i = 0; i < 6; ++i) {
    const float t = static_cast<float>(i);
    const int node = test.addSquare({t - 3.0f, 0.37f * t - 1.0f, -2.0f - 1.7f * t}, 0.9f);
    test.scene.nodes[static_cast<std::size_t>(node)].rotation =
        glm::angleAxis(0.3f * t, glm::vec3(0.6f, 0.8f, 0.0f));
  }
  SceneRenderer renderer(std::make_shared<const Scene>(test.scene));
  FrameRequest request = stillRequest(kWidth, kHeight);
  request.jitter.sequence = JitterSequence::Halton;
  FrameInputs inputs;
  for (int frame = 0; frame < 16; ++frame) {
    request.inputs.motion = MotionSource::Objects;
    renderer.draw(request, frame, inputs);
    const auto none = [](double, double) { return glm::dvec2(0.0); };
    EXPECT_EQ(wrongMotion(inputs.motion.download(), 0.0, none), "") << "frame " << frame;
    request.inputs.motion = MotionSource::CameraFromDepth;
    renderer.draw(request, frame, inputs);
    EXPECT_EQ(wrongMotion(inputs.motion.download(), 1e-3, none), "") << "frame " << frame << ", from depth";
  }
}

TEST_F(MotionTest, APointBehindThePreviousCameraHasNoPreviousPosition) {
  TestScene test = planeScene(-1.0f); // behind the camera of frame 0
  test.move(test.cameraNode, {0.0f, 0.0f, 2.0f});
  for (const MotionSource source : {MotionSource::Objects, MotionSource::CameraFromDepth}) {
    for (const Precision precision : {Precision::Half, Precision::Full}) {
      FrameRequest request = stillRequest(64, 36);
      request.inputs = {precision, source};
      const FrameInputs inputs = drawFrame(test.scene, request, 1);
      EXPECT_EQ(inputs.objectId.download().at(32, 18)[0] > 0.0f, true);
      EXPECT_EQ(wrongMotion(inputs.motion.download(), 0.0,
                            [](double, double) { return glm::dvec2(kNoPreviousPosition); }),
                "");
    }
  }
}

TEST_F(MotionTest, PreviousDepthIsWhatTheSurfaceHadBefore) {
  TestScene test = halfPlaneScene();
  test.move(1, {0.0f, 0.0f, 0.25f}); // 9.75 m at frame 1, 9.5 m at frame 2
  const FrameInputs inputs = drawFrame(test.scene, stillRequest(64, 36), 2);
  const Image previous = inputs.previousDepth.download();
  EXPECT_NEAR(previous.at(3, 18)[0], 9.75f, 1e-4f); // 32-bit depth and matrices
  EXPECT_EQ(previous.at(60, 18)[0], 0.0f);          // the sky
}

TEST_F(MotionTest, JitterMovesEveryPointByItselfAndNoDepth) {
  for (const bool orthographic : {false, true}) {
    TestScene test = planeScene(10.0f);
    test.scene.cameras[0].orthographic = orthographic;
    test.scene.cameras[0].farPlane = 100.0f;
    FrameRequest request = stillRequest(kWidth, kHeight);
    request.jitter.sequence = JitterSequence::Halton;
    const FrameInputs inputs = drawFrame(test.scene, request, 3);
    for (const glm::vec3 point : {glm::vec3(0, 0, -1), glm::vec3(3, -2, -10), glm::vec3(-40, 20, -90)}) {
      const glm::vec4 still = inputs.block.clipFromWorld * glm::vec4(point, 1.0f);
      const glm::vec4 moved = inputs.block.jitteredClipFromWorld * glm::vec4(point, 1.0f);
      const glm::vec2 shift = (glm::vec2(moved) / moved.w - glm::vec2(still) / still.w) * 0.5f;
      EXPECT_NEAR(shift.x * kWidth, inputs.info.jitterPx.x, kTolerancePx);
      EXPECT_NEAR(-shift.y * kHeight, inputs.info.jitterPx.y, kTolerancePx); // window y is down
      EXPECT_EQ(moved.z, still.z);
      EXPECT_EQ(moved.w, still.w);
    }
    const Image jittered = inputs.depth.download();
    const Image plain = drawFrame(test.scene, stillRequest(kWidth, kHeight), 3).depth.download();
    for (std::size_t i = 0; i < plain.pixels.size(); ++i) {
      ASSERT_NEAR(jittered.pixels[i], plain.pixels[i], 1e-6f * plain.pixels[i]); // of the rasterizer's planes
    }
  }
}

} // namespace
} // namespace taa
