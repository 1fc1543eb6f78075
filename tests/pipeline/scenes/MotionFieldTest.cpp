// Motion of every pixel of a frame, jitter included, against closed forms in double precision (invariants 11
// to 13, 15); tests/gl/MotionTest.cpp holds the renderer to them case by case.
#include "core/render/passes/SceneRenderer.h"

#include "tests/support/GlTest.h"
#include "tests/support/frames/SmallScene.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>

#include <cmath>
#include <functional>
#include <initializer_list>
#include <memory>
#include <numbers>

namespace taa {
namespace {

constexpr int kWidth = 192; // 16:9, a tenth of the manual's 1920
constexpr int kHeight = 108;
constexpr double kHalfDegree = std::numbers::pi / 360.0;
const double kTanHalfFov = std::tan(std::numbers::pi / 6.0); // of the camera's 60°
const double kP00 = kHeight / (kWidth * kTanHalfFov);

/// Sub-pixel precision that 32-bit positions and depth leave at this size.
constexpr double kTolerancePx = 1e-3;

/// Motion of the scene sample at a window position of the unjittered raster, px.
using Field = std::function<glm::dvec2(const glm::dvec2& window)>;

/// A plane 10 m away fills the left half of the picture, sky the rest.
Scene planeAndSky() {
  Scene scene = test::emptyScene();
  test::addQuad(scene, {-100, 0, 0}, {200, 0, 0}, {0, 200, 0});
  return scene;
}

glm::vec4 turned(double angle, const glm::vec3& axis) {
  const glm::quat q = glm::angleAxis(static_cast<float>(angle), axis);
  return {q.x, q.y, q.z, q.w};
}

class MotionFieldTest : public test::GlTest {
 protected:
  /// Draws frame 1 with three different jitters and both sources of motion, and compares every pixel.
  static void expectField(const Scene& scene, std::initializer_list<MotionSource> sources,
                          const Field& field) {
    SceneRenderer renderer(std::make_shared<const Scene>(scene));
    FrameInputs inputs;
    FrameRequest request;
    request.camera = test::kEye;
    request.width = kWidth;
    request.height = kHeight;
    request.inputs.precision = Precision::Full;
    for (const MotionSource source : sources) {
      for (const int firstIndex : {1, 2, 6}) {
        request.inputs.motion = source;
        request.jitter.firstIndex = firstIndex;
        renderer.draw(request, 1, inputs);
        ASSERT_NE(inputs.info.jitterPx, glm::vec2(0.0f));
        expectField(inputs, field);
      }
    }
  }

 private:
  static void expectField(const FrameInputs& inputs, const Field& field) {
    const Image motion = inputs.motion.download();
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        // Pixel p holds what belongs to p − j of the picture at rest.
        const glm::dvec2 window = glm::dvec2(x + 0.5, y + 0.5) - glm::dvec2(inputs.info.jitterPx);
        const glm::dvec2 expected = field(window);
        ASSERT_NEAR(motion.at(x, y)[0], expected.x, kTolerancePx) << x << ", " << y;
        ASSERT_NEAR(motion.at(x, y)[1], expected.y, kTolerancePx) << x << ", " << y;
      }
    }
  }
};

TEST_F(MotionFieldTest, ATranslatingPlaneMovesByItsShareOfThePicture) {
  EXPECT_NEAR(kP00, 0.974279, 5e-7);
  EXPECT_NEAR(kP00 * 960.0 * 0.1 / 10.0, 9.35307, 5e-6); // invariant 11, at ten times this width
  const Field field = [](const glm::dvec2&) { return glm::dvec2(0.935307, 0.0); };
  Scene object = test::emptyScene();
  const int plane = test::addQuad(object, {0, 0, 0}, {200, 0, 0}, {0, 200, 0});
  Scene camera = object;
  test::jump(object, plane, AnimationPath::Translation, {0, 0, 0, 0}, {0.1f, 0, 0, 0});
  expectField(object, {MotionSource::Objects}, field);
  test::jump(camera, 0, AnimationPath::Translation, {0.1f, 0, 10, 0}, {0, 0, 10, 0});
  expectField(camera, {MotionSource::Objects, MotionSource::CameraFromDepth}, field);
}

TEST_F(MotionFieldTest, AnOrthographicCameraThatMovesGivesEveryDistanceTheSame) {
  for (const float distance : {2.0f, 50.0f}) {
    Scene scene = test::emptyScene();
    scene.cameras[0].orthographic = true;
    scene.cameras[0].height = 20.0f * kHeight / kWidth; // 20 m wide
    scene.cameras[0].farPlane = 100.0f;
    test::addQuad(scene, {0, 0, 10.0f - distance}, {200, 0, 0}, {0, 200, 0});
    test::jump(scene, 0, AnimationPath::Translation, {0.1f, 0, 10, 0}, {0, 0, 10, 0});
    expectField(scene, {MotionSource::Objects, MotionSource::CameraFromDepth},
                [](const glm::dvec2&) { return glm::dvec2(0.96, 0.0); });
  }
}

TEST_F(MotionFieldTest, YawMovesPlaneAndSkyAlike) {
  // The manual's numbers (invariant 12), for a point that was at ndc 0, 0.5, 0.9 of a picture 1920 wide.
  const auto moved = [](double ndc) {
    return (kP00 * std::tan(std::atan(ndc / kP00) + kHalfDegree) - ndc) * 960.0;
  };
  EXPECT_NEAR(moved(0.0), 8.1623, 5e-5);
  EXPECT_NEAR(moved(0.5), 10.3584, 5e-5);
  EXPECT_NEAR(moved(0.9), 15.2504, 5e-5);
  Scene scene = planeAndSky();
  test::jump(scene, 0, AnimationPath::Rotation, turned(0.0, {0, 1, 0}), turned(kHalfDegree, {0, 1, 0}));
  expectField(scene, {MotionSource::Objects, MotionSource::CameraFromDepth}, [](const glm::dvec2& window) {
    const glm::dvec2 ndc(2.0 * window.x / kWidth - 1.0, 1.0 - 2.0 * window.y / kHeight);
    const double angle = std::atan(ndc.x / kP00);
    const glm::dvec2 previous(kP00 * std::tan(angle - kHalfDegree),
                              ndc.y * std::cos(angle) / std::cos(angle - kHalfDegree));
    return (ndc - previous) * glm::dvec2(0.5 * kWidth, -0.5 * kHeight);
  });
}

TEST_F(MotionFieldTest, RollTurnsThePictureAboutItsCenter) {
  Scene scene = planeAndSky(); // the camera turns counter-clockwise, so the picture clockwise
  test::jump(scene, 0, AnimationPath::Rotation, turned(0.0, {0, 0, 1}), turned(kHalfDegree, {0, 0, 1}));
  expectField(scene, {MotionSource::Objects, MotionSource::CameraFromDepth}, [](const glm::dvec2& window) {
    const glm::dvec2 r = window - glm::dvec2(0.5 * kWidth, 0.5 * kHeight); // y down
    const double c = std::cos(kHalfDegree);
    const double s = std::sin(kHalfDegree);
    const glm::dvec2 v = r - glm::dvec2(c * r.x + s * r.y, c * r.y - s * r.x);
    EXPECT_NEAR(std::hypot(v.x, v.y), 2.0 * std::hypot(r.x, r.y) * std::sin(0.5 * kHalfDegree), 1e-9);
    return v;
  });
}

TEST_F(MotionFieldTest, AnObjectThatTravelsWithTheCameraStandsStill) {
  Scene scene = test::emptyScene();
  const int plane = test::addQuad(scene, {0, 0, 0}, {200, 0, 0}, {0, 200, 0});
  test::jump(scene, plane, AnimationPath::Translation, {0, 0, 0, 0}, {0.7f, -0.2f, 0.5f, 0});
  test::jump(scene, 0, AnimationPath::Translation, {0, 0, 10, 0}, {0.7f, -0.2f, 10.5f, 0});
  expectField(scene, {MotionSource::Objects}, [](const glm::dvec2&) { return glm::dvec2(0.0); });
}

} // namespace
} // namespace taa
