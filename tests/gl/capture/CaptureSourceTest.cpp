// A capture as the source of frames: the same textures and the same block as the renderer it was taken of.
#include "core/capture/source/CaptureSource.h"

#include "core/base/Error.h"
#include "core/base/Half.h"
#include "core/render/CaptureFacts.h"
#include "tests/support/ErrorOf.h"
#include "tests/support/GlTest.h"
#include "tests/support/capture/CapturedShot.h"

#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace taa {
namespace {

using capture::CaptureSource;
using capture::DecodedFrame;
using test::CapturedShot;

constexpr glm::ivec2 kPicturePx{64, 36};

class CaptureSourceTest : public test::GlTest {
 protected:
  static CaptureSource sourceOf(CapturedShot& shot) {
    return {shot.manifest(), [&shot](int index) { return shot.frame(index); }};
  }

  /// One frame that is given, of a manifest that states its camera and jitter.
  static CaptureSource sourceOf(CapturedShot& shot, const DecodedFrame& frame) {
    capture::Manifest manifest = shot.manifest();
    if (!frame.camera)
      for (capture::CapturedFrame& stated : manifest.frames) stated.view = stated.projection = {};
    const auto shared = std::make_shared<const DecodedFrame>(frame);
    return {std::move(manifest), [shared](int) { return shared; }};
  }

  static FrameInputs drawn(FrameSource& source, const FrameRequest& request, int frame) {
    FrameInputs inputs;
    source.draw(request, frame, inputs);
    return inputs;
  }

  static bool isSame(const gl::Texture& a, const gl::Texture& b) {
    if (!a || !b) return !a && !b;
    const Image is = a.download(), should = b.download();
    return a.format() == b.format() && a.size() == b.size() &&
           std::memcmp(is.pixels.data(), should.pixels.data(), is.pixels.size() * sizeof(float)) == 0;
  }

  static void expectSame(const FrameInputs& is, const FrameInputs& should) {
    constexpr std::pair<gl::Texture FrameInputs::*, const char*> kTextures[] = {
        {&FrameInputs::color, "color"},
        {&FrameInputs::depth, "depth"},
        {&FrameInputs::motion, "motion"},
        {&FrameInputs::normal, "normal"},
        {&FrameInputs::objectId, "objectId"},
        {&FrameInputs::previousDepth, "previousDepth"},
        {&FrameInputs::mask, "mask"},
        {&FrameInputs::overlay, "overlay"},
        {&FrameInputs::fog, "fog"}};
    for (const auto& [texture, name] : kTextures) EXPECT_TRUE(isSame(is.*texture, should.*texture)) << name;
    EXPECT_EQ(is.outputPx, should.outputPx);
    EXPECT_EQ(is.info.frame, should.info.frame);
    EXPECT_EQ(is.info.time, should.info.time);
    EXPECT_EQ(is.info.stepSeconds, should.info.stepSeconds);
    EXPECT_EQ(is.info.jitterPx, should.info.jitterPx);
    EXPECT_EQ(is.info.startsHistory, should.info.startsHistory);
    shared::FrameBlock block = is.block; // nothing after the inputs reads the sky
    block.skyZenith = should.block.skyZenith;
    block.skyHorizon = should.block.skyHorizon;
    block.skyGround = should.block.skyGround;
    block.sunDirection = should.block.sunDirection;
    block.sunColor = should.block.sunColor;
    EXPECT_EQ(std::memcmp(&block, &should.block, sizeof(block)), 0) << "block";
  }
};

TEST_F(CaptureSourceTest, GivesTheTexturesAndTheBlockOfTheRenderer) {
  for (const Precision precision : {Precision::Half, Precision::Full})
    for (const std::string scene : {"builtin:fan", "builtin:cut"}) {
      Settings settings;
      settings.inputs.precision = precision;
      CapturedShot shot(scene, kPicturePx, settings, 62);
      CaptureSource source = sourceOf(shot);
      for (const int frame : {0, 1, 7, 60, 61}) { // builtin:cut cuts at 60
        SCOPED_TRACE(scene + ", frame " + std::to_string(frame));
        expectSame(drawn(source, shot.request(), frame), drawn(shot.renderer(), shot.request(), frame));
      }
    }
}

TEST_F(CaptureSourceTest, GivesWhatMayBeMissing) {
  Settings settings;
  settings.inputs.mask = MaskSource::Opacity;
  settings.inputs.blended = BlendedAs::After;
  for (const std::string scene : {"builtin:glass", "builtin:fog"}) {
    SCOPED_TRACE(scene);
    CapturedShot shot(scene, kPicturePx, settings, 3);
    CaptureSource source = sourceOf(shot);
    expectSame(drawn(source, shot.request(), 2), drawn(shot.renderer(), shot.request(), 2));
  }
}

TEST_F(CaptureSourceTest, MakesMotionFromDepthAndMatrices) {
  Settings settings;
  settings.inputs.motion = MotionSource::CameraFromDepth;
  CapturedShot shot("builtin:fence", kPicturePx, settings, 4);
  const FrameInputs should = drawn(shot.renderer(), shot.request(), 3);
  CapturedShot plain("builtin:fence", kPicturePx, Settings{}, 4);
  CaptureSource asked = sourceOf(plain);
  EXPECT_TRUE(isSame(drawn(asked, shot.request(), 3).motion, should.motion));
}

// Of matrices alone nothing is made: without depth everything would move as the sky does.
TEST_F(CaptureSourceTest, StandsStillWithoutDepthWhateverTheMatricesSay) {
  CapturedShot shot("builtin:fence", kPicturePx, Settings{}, 4);
  DecodedFrame frame = *shot.frame(3);
  frame.motion = frame.previousDepth = frame.depth = Image();
  ASSERT_NE(frame.camera, frame.previousCamera);
  CaptureSource source = sourceOf(shot, frame);
  FrameRequest request = shot.request();
  for (const MotionSource motion : {MotionSource::Objects, MotionSource::CameraFromDepth}) {
    request.inputs.motion = motion;
    const FrameInputs inputs = drawn(source, request, 3);
    for (const float value : inputs.motion.download().pixels) ASSERT_EQ(value, 0.0f);
    for (const float value : inputs.previousDepth.download().pixels) ASSERT_EQ(value, 0.0f);
  }
}

TEST_F(CaptureSourceTest, KnowsWhatSomeOfItsFramesHave) {
  CapturedShot shot("builtin:fan", {8, 8}, Settings{}, 3);
  capture::Manifest manifest = shot.manifest();
  EXPECT_TRUE(CaptureSource(manifest, {}).capture()->hasCameraMotion);
  manifest.frames[2].planes[capture::PlaneKind::Reference].file = "of the last frame alone";
  manifest.frames[1].planes[capture::PlaneKind::Output].file = "from the second frame on";
  manifest.planes.erase(capture::PlaneKind::Depth);
  for (capture::CapturedFrame& frame : manifest.frames) frame.number += 100;
  CaptureSource source(manifest, [&shot](int index) { return shot.frame(index); });
  EXPECT_TRUE(source.capture()->hasReference);
  EXPECT_TRUE(source.capture()->hasOutput);
  EXPECT_FALSE(source.capture()->hasMask);
  EXPECT_FALSE(source.capture()->hasCameraMotion) << "there is no depth to make it of";
  EXPECT_EQ(test::errorOf([&] { source.reference(1); }), "frame 101 of this capture has no reference");
}

TEST_F(CaptureSourceTest, StandsStillWithoutMotionAndMatrices) {
  CapturedShot shot("builtin:fence", kPicturePx, Settings{}, 4);
  DecodedFrame frame = *shot.frame(3);
  frame.camera = frame.previousCamera = {};
  frame.motion = frame.previousDepth = frame.normal = Image();
  frame.objectId.clear();
  frame.nearPlane = 0.25;
  CaptureSource source = sourceOf(shot, frame);
  EXPECT_FALSE(source.capture()->hasCameraMotion);
  const FrameInputs inputs = drawn(source, shot.request(), 3);
  const Image motion = inputs.motion.download(), depth = inputs.depth.download(),
              previous = inputs.previousDepth.download(), ids = inputs.objectId.download();
  for (int y = 0; y < kPicturePx.y; ++y)
    for (int x = 0; x < kPicturePx.x; ++x) {
      ASSERT_EQ(motion.texel(x, y), glm::vec4(0.0f));
      ASSERT_EQ(*ids.at(x, y), 0.0f);
      const float d = *depth.at(x, y);
      ASSERT_FLOAT_EQ(*previous.at(x, y), d > 0.0f ? 0.25f / d : 0.0f) << "as far away as now";
    }
}

TEST_F(CaptureSourceTest, RoundsToTheNearestHalfAndKeepsColorsFinite) {
  Settings settings;
  settings.inputs.precision = Precision::Full;
  CapturedShot shot("builtin:fan", kPicturePx, settings, 1);
  DecodedFrame frame = *shot.frame(0);
  frame.color.pixels[0] = 1e6f;
  frame.color.pixels[1] = -1e6f;
  CaptureSource source = sourceOf(shot, frame);
  FrameRequest half = shot.request();
  half.inputs.precision = Precision::Half;
  const FrameInputs inputs = drawn(source, half, 0);
  const Image color = inputs.color.download(), motion = inputs.motion.download();
  EXPECT_EQ(color.pixels[0], 65504.0f);
  EXPECT_EQ(color.pixels[1], -65504.0f);
  for (std::size_t at = 2; at < color.pixels.size(); ++at)
    ASSERT_EQ(color.pixels[at], roundedToHalf(frame.color.pixels[at])) << at;
  for (std::size_t at = 0; at < motion.pixels.size(); ++at)
    ASSERT_EQ(motion.pixels[at], roundedToHalf(frame.motion.pixels[at])) << at;
}

TEST_F(CaptureSourceTest, StartsHistoryAtCutsAndWhereItIsAskedTo) {
  CapturedShot shot("builtin:cut", kPicturePx, Settings{}, 62);
  const CaptureSource source = sourceOf(shot);
  FrameRequest request = shot.request();
  request.restarts = {5};
  for (const auto& [frame, starts] : std::vector<std::pair<int, bool>>{
           {0, true}, {4, false}, {5, true}, {59, false}, {60, true}, {61, false}})
    EXPECT_EQ(source.info(request, frame).startsHistory, starts) << frame;
}

TEST_F(CaptureSourceTest, HasOneCameraAndSaysSo) {
  CapturedShot shot("builtin:fan", kPicturePx, Settings{}, 2);
  const CaptureSource source = sourceOf(shot);
  FrameRequest request = shot.request();
  request.camera = kCaptureCamera;
  EXPECT_EQ(source.camera(request, 1).viewFromWorld, shot.renderer().camera(shot.request(), 1).viewFromWorld);
  request.camera = "orbit";
  EXPECT_THROW(source.camera(request, 1), Error);
}

TEST_F(CaptureSourceTest, KnowsItsJitterPatternAndThatItHasNoReference) {
  CapturedShot shot("builtin:fan", {8, 8}, Settings{}, 40);
  CaptureSource source = sourceOf(shot);
  EXPECT_EQ(source.capture()->jitterPeriod, 16);
  EXPECT_EQ(source.info(shot.request(), 37).jitterIndex, 5);
  EXPECT_THROW(source.reference(0), Error);
  EXPECT_EQ(source.engineOutput(0), nullptr);
}

} // namespace
} // namespace taa
