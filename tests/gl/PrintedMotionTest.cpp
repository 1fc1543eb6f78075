// Motion of objects as two sources print it (manual §26, D6 and D16), against closed forms.
#include "tests/support/CompareImages.h"
#include "tests/support/frames/MotionFixture.h"

#include <glm/trigonometric.hpp>

#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace taa {
namespace {

using test::addQuad;
using test::emptyScene;
using test::fromMiddle;
using test::jump;
using test::kHeight;
using test::kP00;
using test::kRight;
using test::kUp;
using test::kWidth;

class PrintedMotionTest : public test::MotionFixture {
 protected:
  static FrameRequest printed() { return request(MotionSource::ObjectsAsPrinted); }
  /// Looks along −z from (0, 0, 10); yaw and field of view by frame.
  static FrameRequest flown(MotionSource source, std::vector<CameraPose> poses) {
    FrameRequest asked = request(source);
    for (CameraPose& pose : poses) pose.position = {0, 0, 10};
    asked.track = std::make_shared<const CameraTrack>(CameraTrack{"t", 0, std::move(poses)});
    return asked;
  }
};

// D6: v = w·r − r', r from the middle of the picture; nothing moves, so r' = r.
// Techniques: D6.
TEST_F(PrintedMotionTest, ForgetsToDivideTheCurrentPosition) {
  for (const bool moves : {false, true}) {
    Scene scene = emptyScene();
    const int plane = addQuad(scene, {0, 0, 0}, {40, 0, 10}, kUp);
    // The previous position uses the current pose: what moves seems to rest.
    if (moves) jump(scene, plane, AnimationPath::Translation, {0.3f, 0.1f, 2.0f, 0}, {0, 0, 0, 0});
    const FrameInputs inputs = draw(scene, printed());
    const Image field = inputs.motion.download(), depth = inputs.depth.download();
    for (const glm::ivec2 pixel : {glm::ivec2(0, 0), glm::ivec2(160, 90), glm::ivec2(319, 20)}) {
      const float w = 0.1f / depth.texel(pixel.x, pixel.y).x; // view depth, near plane 0.1 m
      const glm::vec2 expected = (w - 1.0f) * fromMiddle(inputs.info, pixel.x, pixel.y);
      EXPECT_NEAR(field.texel(pixel.x, pixel.y).x, expected.x, 2e-3f) << "of up to 3000 px";
      EXPECT_NEAR(field.texel(pixel.x, pixel.y).y, expected.y, 2e-3f);
    }
  }
}

TEST_F(PrintedMotionTest, UsesThePreviousCamera) {
  Scene scene = emptyScene();
  addQuad(scene, {0, 0, 0}, kRight, kUp);
  jump(scene, 0, AnimationPath::Translation, {0.1f, 0, 10, 0}, {0, 0, 10, 0});
  const FrameInputs inputs = draw(scene, printed());
  const Image field = inputs.motion.download();
  for (const int x : {3, 160, 290}) {
    const float r = fromMiddle(inputs.info, x, 90).x, before = r - kP00 * kWidth / 2 * 0.1f / 10.0f;
    EXPECT_NEAR(field.texel(x, 90).x, 10.0f * r - before, 1e-3f);
  }
}

TEST_F(PrintedMotionTest, IsRightWithoutPerspectiveForWhatRests) {
  Scene scene = emptyScene();
  scene.cameras[0].orthographic = true;
  scene.cameras[0].height = 11.25f;
  scene.cameras[0].farPlane = 100.0f;
  addQuad(scene, {0, 0, 0}, {4, 1, 3}, {0, 4, 1});
  const int sways = addQuad(scene, {0, 2, 1}, {3, 0, 0}, {0, 1, 0});
  for (Vertex& vertex : scene.meshes.back().primitives.front().vertices) vertex.uv1.y = 1.0f;
  scene.materials[0].wind = {0.5f, 0.0f, 9.0f, {1, 0, 0}};
  jump(scene, 0, AnimationPath::Translation, {0.1f, 0, 10, 0}, {0, 0.2f, 10, 0});
  FrameRequest camera = request();
  camera.motionModes = {{scene.nodes[static_cast<std::size_t>(sways)].name, MotionMode::CameraOnly}};
  EXPECT_EQ(test::difference(motion(scene, printed()), motion(scene, camera), 1e-5f), "");
  EXPECT_FALSE(test::agree(motion(scene, printed()), motion(scene), 1e-5f)) << "vertices sway";
}

TEST_F(PrintedMotionTest, LeavesSkyAndWhatIsForcedToRestAlone) {
  Scene scene = emptyScene();
  addQuad(scene, {0, 0, 0}, {4, 1, 3}, {0, 4, 1});
  jump(scene, 0, AnimationPath::Rotation, {0, 0, 0, 1}, {0, std::sin(0.01f), 0, std::cos(0.01f)});
  FrameRequest asked = printed();
  asked.motionModes = {{"quad", MotionMode::None}};
  const FrameInputs forced = draw(scene, asked);
  const Image field = forced.motion.download(), ids = forced.objectId.download();
  const Image right = motion(scene);
  int onQuad = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const bool isQuad = ids.at(x, y)[0] != 0.0f;
      onQuad += isQuad;
      for (int axis = 0; axis < 2; ++axis)
        ASSERT_EQ(field.at(x, y)[axis], isQuad ? 0.0f : right.at(x, y)[axis]);
    }
  EXPECT_GT(onQuad, 1000);
}

// What is too large to be kept reads as having no previous position, like everything else that does.
TEST_F(PrintedMotionTest, IsMarkedWhereItIsTooLarge) {
  Scene scene = emptyScene();
  addQuad(scene, {0, 0, -990}, 100.0f * kRight, 100.0f * kUp); // at 1000 m: up to 160,000 px
  EXPECT_EQ(motion(scene, printed()).texel(0, 90).x, kNoPreviousPosition);
  EXPECT_LT(std::abs(motion(scene, printed()).texel(160, 90).x), 1000.0f);
}

TEST_F(PrintedMotionTest, TransparentSurfacesWriteItToo) {
  Scene scene = emptyScene();
  Material glass = scene.materials.front();
  glass.baseColor.w = 0.5f;
  glass.alphaMode = AlphaMode::Blend;
  scene.materials.push_back(glass);
  addQuad(scene, {0, 0, 0}, kRight, kUp, 1);
  FrameRequest asked = printed();
  asked.inputs.blended = BlendedAs::BeforeWithMotion;
  const FrameInputs inputs = draw(scene, asked);
  EXPECT_NEAR(inputs.motion.download().texel(30, 40).x, 9.0f * fromMiddle(inputs.info, 30, 40).x, 2e-3f);
}

// D16: this frame's projection for both, so that a zoom alone moves nothing, the sky included.
// Techniques: D16.
TEST_F(PrintedMotionTest, OfThisFramesProjectionMissesTheZoom) {
  Scene scene = emptyScene();
  addQuad(scene, {0, 0, 0}, {8, 1, 0}, {0, 8, 1}); // and sky around it
  const std::vector<CameraPose> zoom{{.fovY = 45.0f}, {.fovY = 40.0f}};
  for (const float value : motion(scene, flown(MotionSource::CurrentProjectionAsPrinted, zoom)).pixels)
    ASSERT_EQ(value, 0.0f);
  const FrameInputs right = draw(scene, flown(MotionSource::Objects, zoom));
  const float shrunk = std::tan(glm::radians(20.0f)) / std::tan(glm::radians(22.5f));
  for (const glm::ivec2 pixel : {glm::ivec2(5, 7), glm::ivec2(160, 60), glm::ivec2(300, 150)})
    for (int axis = 0; axis < 2; ++axis)
      EXPECT_NEAR(right.motion.download().texel(pixel.x, pixel.y)[axis],
                  (1.0f - shrunk) * fromMiddle(right.info, pixel.x, pixel.y)[axis], 1e-3f);
}

TEST_F(PrintedMotionTest, OfThisFramesProjectionTurnsWithItsSlope) {
  Scene scene = emptyScene();
  const float fov = 40.0f, slope = 1.0f / std::tan(glm::radians(0.5f * fov)) * kHeight / kWidth;
  // The camera turns to the right by half a degree and zooms: the picture moves to the left.
  const std::vector<CameraPose> poses{{.fovY = 45.0f}, {.yaw = 0.5f, .fovY = fov}};
  const FrameInputs inputs = draw(scene, flown(MotionSource::CurrentProjectionAsPrinted, poses));
  for (const int x : {10, 160, 300}) {
    const float now = fromMiddle(inputs.info, x, kHeight / 2).x * 2.0f / kWidth;
    const float before = slope * std::tan(std::atan(now / slope) + glm::radians(0.5f));
    EXPECT_NEAR(inputs.motion.download().texel(x, kHeight / 2).x, (now - before) * kWidth / 2, 1e-3f);
  }
}

TEST_F(PrintedMotionTest, OfThisFramesProjectionIsRightWhileNothingZooms) {
  Scene scene = emptyScene();
  const int plane = addQuad(scene, {0, 0, 0}, {4, 1, 3}, {0, 4, 1});
  jump(scene, plane, AnimationPath::Translation, {0.3f, 0.1f, 2.0f, 0}, {0, 0, 0, 0});
  jump(scene, 0, AnimationPath::Translation, {0.1f, 0, 10, 0}, {0, 0, 9, 0});
  const FrameInputs printed = draw(scene, request(MotionSource::CurrentProjectionAsPrinted));
  const FrameInputs right = draw(scene, request());
  EXPECT_EQ(test::difference(printed.motion.download(), right.motion.download()), "");
  EXPECT_EQ(test::difference(printed.previousDepth.download(), right.previousDepth.download()), "");
}

} // namespace
} // namespace taa
