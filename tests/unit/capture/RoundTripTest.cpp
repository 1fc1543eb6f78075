// Frames in any convention come back as they were, to the precision of what is stored.
#include "core/capture/decode/DecodedFrame.h"
#include "core/render/FrameInputs.h"
#include "tests/unit/capture/CaptureFixtures.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/vec3.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace taa::capture {
namespace {

constexpr glm::ivec2 kSize(33, 17);

DecodedCamera cameraOf(int frame, bool isOrthographic) {
  DecodedCamera camera;
  const glm::dvec3 eye(1.0 + 0.1 * frame, 2.0, 5.0 - 0.2 * frame);
  camera.viewFromWorld = glm::lookAt(eye, glm::dvec3(0.1, 0.2, 0.3), glm::dvec3(0, 1, 0));
  camera.orthographic = isOrthographic;
  camera.clipFromView = glm::dmat4(0.0);
  camera.clipFromView[0][0] = 0.9;
  camera.clipFromView[1][1] = 1.6;
  if (isOrthographic) {
    camera.clipFromView[2][2] = 1.0 / 99.9;
    camera.clipFromView[3] = {0.1, -0.2, 100.0 / 99.9, 1.0};
  } else {
    camera.clipFromView[2] = {0.1, -0.2, 0.0, -1.0};
    camera.clipFromView[3][2] = 0.1;
  }
  return camera;
}

/// Frame 1 of two, with values of all kinds: sky, what has no previous position, and what rests.
DecodedFrame frameOf(std::mt19937& random, bool isOrthographic) {
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  DecodedFrame frame;
  frame.index = 1;
  frame.jitterPx = {unit(random) - 0.5f, unit(random) - 0.5f};
  frame.previousJitterPx = {unit(random) - 0.5f, unit(random) - 0.5f};
  frame.seconds = 0.25;
  frame.camera = cameraOf(1, isOrthographic);
  frame.previousCamera = cameraOf(0, isOrthographic);
  frame.nearPlane = 0.1;
  frame.color = Image(kSize.x, kSize.y, 4);
  frame.motion = Image(kSize.x, kSize.y, 2);
  frame.depth = Image(kSize.x, kSize.y, 1);
  frame.normal = Image(kSize.x, kSize.y, 4);
  for (float& value : frame.color.pixels) value = 4.0f * unit(random);
  for (float& value : frame.motion.pixels) value = 20.0f * unit(random) - 10.0f;
  // No farther than 50 m, so that what is beyond a far plane is sky alone.
  for (float& value : frame.depth.pixels)
    value = isOrthographic ? 0.5f + 0.5f * unit(random) : 0.1f / (0.2f + 49.8f * unit(random));
  for (float& value : frame.normal.pixels) value = unit(random);
  for (std::size_t i = 3; i < frame.normal.pixels.size(); i += 4)
    frame.normal.pixels[i] = std::floor(5.0f * unit(random)); // classes
  for (std::size_t i = 0; i < frame.depth.pixels.size(); ++i) {
    if (i % 5 == 0) frame.depth.pixels[i] = 0.0f;
    if (i % 7 == 0) frame.motion.pixels[2 * i] = frame.motion.pixels[2 * i + 1] = 0.0f;
    if (i % 11 == 0) frame.motion.pixels[2 * i] = frame.motion.pixels[2 * i + 1] = kNoPreviousPosition;
    frame.objectId.push_back(static_cast<std::uint32_t>(random()));
  }
  frame.output = frame.color;
  return frame;
}

DecodedFrame wayAndBack(const Conventions& conventions, const DecodedFrame& frame) {
  Manifest manifest = manifestOf(conventions, kSize, 3);
  manifest.outputPx = {66, 51};
  DecodedFrame before = frame;
  before.index = 0;
  before.startsHistory = true;
  before.jitterPx = frame.previousJitterPx;
  before.camera = before.previousCamera = frame.previousCamera;
  for (CapturedFrame& stated : manifest.frames) stated.preExposure = 1.7;
  encodeFrame(manifest, 0, before);
  encodeFrame(manifest, 1, frame);
  return decode(manifest, 1, encode(manifest, frame));
}

void expectNear(const Image& image, const Image& expected, float relative, float absolute,
                const std::string& what) {
  ASSERT_EQ(image.pixels.size(), expected.pixels.size()) << what;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const float value = expected.pixels[i];
    ASSERT_NEAR(image.pixels[i], value, absolute + relative * std::abs(value)) << what << ", value " << i;
  }
}

void expectNear(const glm::dmat4& m, const glm::dmat4& expected, const std::string& what) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) ASSERT_NEAR(m[column][row], expected[column][row], 1e-9) << what;
}

/// What is compared where motion is as it stands: the rest is what a fallback says.
bool isMotionStored(const MotionConventions& motion, const DecodedFrame& frame, std::size_t pixel) {
  const bool isSky = frame.depth.pixels[pixel] == 0.0f;
  const bool isMark = frame.motion.pixels[2 * pixel] == kNoPreviousPosition;
  if (isSky && motion.whereNothing) return false;
  return !isMark || motion.encoding != MotionEncoding::Unreal || motion.fallback == MotionFallback::None;
}

void expectSameMotion(const Conventions& conventions, const DecodedFrame& decoded, const DecodedFrame& frame,
                      const std::string& what) {
  ASSERT_EQ(decoded.motion.pixels.size(), frame.motion.pixels.size()) << what;
  const double largest = std::abs(conventions.motion.offset.x) + std::abs(conventions.motion.offset.y);
  const double scale = std::max(std::abs(conventions.motion.scale.x), std::abs(conventions.motion.scale.y));
  // Floats of up to 1000 px where camera motion was taken off; an offset takes bits of what it is added to.
  const float tolerance = 2e-4f + static_cast<float>(largest * scale * 33.0 * 1.2e-7);
  for (std::size_t i = 0; i < frame.depth.pixels.size(); ++i) {
    if (!isMotionStored(conventions.motion, frame, i)) continue;
    for (std::size_t c = 2 * i; c < 2 * i + 2; ++c) {
      if (frame.motion.pixels[c] == kNoPreviousPosition)
        ASSERT_EQ(decoded.motion.pixels[c], kNoPreviousPosition) << what << ", value " << c;
      else
        ASSERT_NEAR(decoded.motion.pixels[c], frame.motion.pixels[c], tolerance) << what << ", value " << c;
    }
  }
}

void expectSame(const Conventions& conventions, const DecodedFrame& frame, const std::string& what) {
  const DecodedFrame decoded = wayAndBack(conventions, frame);
  EXPECT_NEAR(decoded.jitterPx.x, frame.jitterPx.x, 1e-7f) << what;
  EXPECT_NEAR(decoded.jitterPx.y, frame.jitterPx.y, 1e-7f) << what;
  EXPECT_EQ(decoded.seconds, frame.seconds) << what;
  ASSERT_TRUE(decoded.camera) << what;
  expectNear(decoded.camera->viewFromWorld, frame.camera->viewFromWorld, what);
  expectNear(decoded.camera->clipFromView, frame.camera->clipFromView, what);
  // A delay leaves the jitter of frame 0 or 2 unstated, which is that of the previous camera or of nobody.
  if (conventions.jitter.delay <= 0 || !conventions.matrices.jittered)
    expectNear(decoded.previousCamera->clipFromView, frame.previousCamera->clipFromView, what);
  expectNear(decoded.color, frame.color, 1e-6f, 0.0f, what);
  expectNear(decoded.output, frame.output, 1e-6f, 0.0f, what);
  EXPECT_EQ(decoded.normal.pixels, frame.normal.pixels) << what;
  EXPECT_EQ(decoded.objectId, frame.objectId) << what;
  // Windows that are not reversed are floats below 1, those of −1…1 twice as coarse.
  expectNear(decoded.depth, frame.depth, 1e-6f, 1.5e-7f, what);
  for (std::size_t i = 0; i < frame.depth.pixels.size(); i += 5)
    ASSERT_EQ(decoded.depth.pixels[i], 0.0f) << what;
  expectSameMotion(conventions, decoded, frame, what);
}

template <typename Value>
Value oneOf(std::mt19937& random, std::initializer_list<Value> values) {
  return values.begin()[random() % values.size()];
}

MotionConventions randomMotion(std::mt19937& random) {
  MotionConventions motion;
  motion.direction =
      oneOf(random, {MotionDirection::CurrentMinusPrevious, MotionDirection::PreviousMinusCurrent});
  motion.unit = oneOf(random, {ScreenUnit::Pixels, ScreenUnit::Uv, ScreenUnit::Ndc});
  motion.pixelOf = oneOf(random, {PixelOf::Render, PixelOf::Output});
  motion.yAxis = oneOf(random, {VerticalAxis::Down, VerticalAxis::Up});
  motion.encoding = oneOf(random, {MotionEncoding::Plain, MotionEncoding::Unreal, MotionEncoding::Offset});
  motion.scale = {oneOf(random, {1.0, -1.0, 0.5, 3.0}), oneOf(random, {1.0, -1.0, 0.25})};
  if (motion.encoding == MotionEncoding::Offset) motion.offset = {0.5, oneOf(random, {0.0, 0.25})};
  if (motion.encoding == MotionEncoding::Unreal) { // whose 16 bits hold twice the picture
    motion.unit = ScreenUnit::Ndc;
    motion.scale = glm::dvec2(1.0);
  }
  motion.includesCamera = random() % 2 == 0 || motion.encoding == MotionEncoding::Unreal;
  motion.notWritten = oneOf<std::optional<double>>(random, {std::nullopt, 0.0, -7.5});
  if (motion.encoding == MotionEncoding::Unreal) motion.notWritten = 0.0;
  motion.fallback = oneOf(random, {MotionFallback::Camera, MotionFallback::Zero, MotionFallback::None});
  motion.whereNothing = oneOf<std::optional<MotionFallback>>(random, {std::nullopt, MotionFallback::Camera});
  return motion;
}

Conventions randomConventions(std::mt19937& random) {
  Conventions c;
  c.motion = randomMotion(random);
  c.jitter.unit = oneOf(random, {ScreenUnit::Pixels, ScreenUnit::Uv, ScreenUnit::Ndc});
  c.jitter.meaning = oneOf(random, {JitterMeaning::Content, JitterMeaning::Sample});
  c.jitter.yAxis = oneOf(random, {VerticalAxis::Down, VerticalAxis::Up});
  c.jitter.delay = oneOf(random, {-1, 0, 1});
  // Jitter of the frame before is not stated with a delay of 1.
  if (c.jitter.delay != 1)
    c.motion.jitter = oneOf(random, {JitterInMotion::Removed, JitterInMotion::Both, JitterInMotion::Current,
                                     JitterInMotion::Previous});
  c.depth.kind = oneOf(random, {DepthKind::Window, DepthKind::Planar, DepthKind::Radial});
  c.depth.reversed = random() % 2 == 0;
  c.depth.range = oneOf(random, {ClipRange::ZeroToOne, ClipRange::MinusOneToOne});
  c.depth.nearPlane = oneOf(random, {0.0, 0.05});
  c.depth.farPlane = oneOf(random, {0.0, 200.0});
  c.depth.scale = oneOf(random, {1.0, -0.5});
  c.depth.nothing = oneOf<std::optional<double>>(random, {std::nullopt, 1e10});
  c.depth.jittered = random() % 2 == 0;
  c.matrices.order = oneOf(random, {MatrixOrder::RowMajor, MatrixOrder::ColumnMajor});
  c.matrices.vectors = oneOf(random, {VectorSide::Column, VectorSide::Row});
  c.matrices.clipZ = oneOf(random, {ClipRange::ZeroToOne, ClipRange::MinusOneToOne});
  c.matrices.clipY = oneOf(random, {VerticalAxis::Down, VerticalAxis::Up});
  c.matrices.forward = oneOf(random, {ForwardAxis::NegativeZ, ForwardAxis::PositiveZ});
  c.matrices.jittered = random() % 2 == 0 && c.jitter.delay != 1;
  c.matrices.metersPerUnit = oneOf(random, {1.0, 0.5});
  c.color.encoding = oneOf(random, {ColorEncoding::Linear, ColorEncoding::Srgb});
  c.color.preExposed = random() % 2 == 0;
  return c;
}

std::string described(const Conventions& conventions) {
  std::string text;
  for (const std::string& assignment : differences(conventions, {})) text += assignment + " ";
  return text;
}

} // namespace

TEST(RoundTrip, OfEveryStartingPoint) {
  std::mt19937 random(1);
  for (const StartingPoint& point : startingPoints())
    for (const bool isOrthographic : {false, true}) {
      // A window's depth of centimeters needs a far plane where the camera has none of its own.
      expectSame(point.conventions, frameOf(random, isOrthographic), std::string(point.id));
      if (testing::Test::HasFatalFailure()) return;
    }
}

TEST(RoundTrip, OfRandomConventions) {
  std::mt19937 random(7);
  for (int i = 0; i < 1000; ++i) {
    Conventions conventions = randomConventions(random);
    const bool isOrthographic = random() % 4 == 0;
    // An orthographic window has both planes or none.
    if (isOrthographic) conventions.depth.nearPlane = 0.0;
    expectSame(conventions, frameOf(random, isOrthographic), described(conventions));
    if (testing::Test::HasFailure()) return;
  }
}

TEST(RoundTrip, OwnConventionsKeepEveryBit) {
  std::mt19937 random(3);
  for (const Conventions& conventions : {Conventions{}, startingPoint("taa-inspector").conventions}) {
    const DecodedFrame frame = frameOf(random, false);
    const DecodedFrame decoded = wayAndBack(conventions, frame);
    EXPECT_EQ(decoded.color.pixels, frame.color.pixels);
    EXPECT_EQ(decoded.motion.pixels, frame.motion.pixels);
    EXPECT_EQ(decoded.depth.pixels, frame.depth.pixels);
    EXPECT_EQ(decoded.camera, frame.camera);
    EXPECT_EQ(decoded.previousCamera, frame.previousCamera);
    EXPECT_EQ(decoded.jitterPx, frame.jitterPx);
    EXPECT_EQ(decoded.previousJitterPx, frame.previousJitterPx);
  }
}

} // namespace taa::capture
