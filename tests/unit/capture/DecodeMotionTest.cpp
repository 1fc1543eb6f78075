// Motion of every engine, from pixels that were computed by hand from what the engines' documents say.
#include "core/base/Error.h"
#include "core/capture/decode/DecodedFrame.h"
#include "core/render/FrameInputs.h"
#include "tests/unit/capture/CaptureFixtures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace taa::capture {
namespace {

constexpr glm::ivec2 kSize(200, 100);

/// The decoded motion of pixel (x, y) of a frame 1 whose motion is (storedX, storedY) everywhere.
glm::vec2 decodedMotion(const Manifest& manifest, float storedX, float storedY, glm::ivec2 pixel = {50, 50}) {
  FramePlanes planes = planesOf(manifest);
  planes[PlaneKind::Motion] = planeFrom(manifest.sizePx.x, manifest.sizePx.y, 2, {storedX, storedY});
  const DecodedFrame frame = decode(manifest, 1, planes);
  return {frame.motion.at(pixel.x, pixel.y)[0], frame.motion.at(pixel.x, pixel.y)[1]};
}

/// What each engine stores where content went 3 px to the right and 2 px down since the frame before.
struct Stored {
  const char* engine;
  float x, y;
};
const std::vector<Stored> kStored = {
    {"taa-inspector", 3.0f, 2.0f}, {"unity", 0.015f, 0.02f}, {"godot", -0.015f, -0.02f},
    {"bevy", 0.015f, 0.02f},       {"three", 0.03f, -0.04f}, {"babylon", -0.015f, 0.02f},
    {"fsr", -3.0f, -2.0f},         {"xess", -3.0f, -2.0f},   {"streamline", -0.015f, -0.02f},
    {"metalfx", -3.0f, -2.0f},     {"blender", -3.0f, 2.0f},
};

} // namespace

TEST(DecodeMotion, TakesWhatEachEngineStores) {
  for (const Stored& stored : kStored) {
    const glm::vec2 px = decodedMotion(manifestLike(stored.engine, kSize), stored.x, stored.y);
    // A stored float has 24 bits: 0.03 · 2⁻²⁵ of a width of 100 px.
    EXPECT_NEAR(px.x, 3.0f, 1e-6f) << stored.engine;
    EXPECT_NEAR(px.y, 2.0f, 1e-6f) << stored.engine;
  }
  EXPECT_EQ(kStored.size() + 1, startingPoints().size()) << "Unreal has a test of its own";
}

TEST(DecodeMotion, TakesUnrealsSixteenBits) {
  // v = (3·2/200, −2·2/100): √(2·0.03) · 0.2495 + 32767/65535 = 36772.16 / 65535; −√(2·0.04) …: 28142.24.
  const glm::vec2 px = decodedMotion(manifestLike("unreal", kSize), 36772.0f / 65535.0f, 28142.0f / 65535.0f);
  // Half a step of 1/65535 is 3.06e-5 of the root, times the root 0.28 is 8.7e-6 of NDC, 100 px each.
  EXPECT_NEAR(px.x, 3.0f, 9e-4f);
  EXPECT_NEAR(px.y, 2.0f, 9e-4f);
  const glm::vec2 rest =
      decodedMotion(manifestLike("unreal", kSize), 32767.0f / 65535.0f, 32767.0f / 65535.0f);
  EXPECT_NEAR(rest.x, 0.0f, 1e-9f);
  EXPECT_NEAR(rest.y, 0.0f, 1e-9f);
}

TEST(DecodeMotion, TakesOffAnOffsetBeforeItScales) {
  Conventions conventions;
  conventions.motion.encoding = MotionEncoding::Offset;
  conventions.motion.offset = {0.5, 0.25};
  conventions.motion.scale = {64.0, -32.0};
  const glm::vec2 px = decodedMotion(manifestOf(conventions, kSize), 0.75f, 0.5f);
  EXPECT_EQ(px.x, 16.0f);
  EXPECT_EQ(px.y, -8.0f);
}

TEST(DecodeMotion, PixelsOfTheOutputAreLargerPixelsOfTheRender) {
  Conventions conventions;
  conventions.motion.pixelOf = PixelOf::Output;
  Manifest manifest = manifestOf(conventions, kSize);
  manifest.outputPx = {400, 400};
  const glm::vec2 px = decodedMotion(manifest, 8.0f, 8.0f);
  EXPECT_EQ(px.x, 4.0f);
  EXPECT_EQ(px.y, 2.0f);
}

TEST(DecodeMotion, LeavesNoJitterInIt) {
  Conventions conventions;
  Manifest manifest = manifestOf(conventions, kSize);
  manifest.frames[0].jitter = {0.25, -0.25};
  manifest.frames[1].jitter = {-0.125, 0.375};
  const auto decoded = [&](JitterInMotion kind) {
    manifest.conventions.motion.jitter = kind;
    return decodedMotion(manifest, 3.0f, 2.0f);
  };
  EXPECT_EQ(decoded(JitterInMotion::Removed), glm::vec2(3.0f, 2.0f));
  // A place is what it is without jitter plus the jitter of its frame.
  EXPECT_EQ(decoded(JitterInMotion::Both), glm::vec2(3.0f + 0.375f, 2.0f - 0.625f));
  EXPECT_EQ(decoded(JitterInMotion::Current), glm::vec2(3.125f, 1.625f));
  EXPECT_EQ(decoded(JitterInMotion::Previous), glm::vec2(3.25f, 1.75f));
}

TEST(DecodeMotion, WhatIsNotWrittenIsWhatTheFallbackSays) {
  Conventions conventions;
  conventions.motion.notWritten = 0.1; // neither a float nor a half is exactly this
  const auto decoded = [&](MotionFallback fallback, float stored) {
    conventions.motion.fallback = fallback;
    return decodedMotion(manifestOf(conventions, kSize), stored, stored);
  };
  EXPECT_EQ(decoded(MotionFallback::Zero, 0.1f), glm::vec2(0.0f));
  EXPECT_EQ(decoded(MotionFallback::Zero, 0.0999755859375f), glm::vec2(0.0f)) << "0.1 as a half";
  EXPECT_EQ(decoded(MotionFallback::None, 0.1f), glm::vec2(kNoPreviousPosition));
  EXPECT_EQ(decoded(MotionFallback::Camera, 0.1f), glm::vec2(0.0f)) << "there is no camera";
  EXPECT_EQ(decoded(MotionFallback::None, 0.125f), glm::vec2(0.125f));
}

// A target that is cleared to the middle of 0 to 1 holds no half of 65535 steps, but one of its neighbors.
TEST(DecodeMotion, WhatIsNotWrittenIsKnownInNormalizedFormats) {
  Conventions conventions;
  conventions.motion.notWritten = 0.5;
  conventions.motion.fallback = MotionFallback::None;
  const auto isLeftOut = [&](double stored) {
    const auto value = static_cast<float>(stored);
    return decodedMotion(manifestOf(conventions, kSize), value, value) == glm::vec2(kNoPreviousPosition);
  };
  for (const double stored : {127.0 / 255.0, 128.0 / 255.0, 32767.0 / 65535.0, 32768.0 / 65535.0, 0.5})
    EXPECT_TRUE(isLeftOut(stored)) << stored;
  for (const double stored : {126.0 / 255.0, 129.0 / 255.0, 32766.0 / 65535.0, 32769.0 / 65535.0})
    EXPECT_FALSE(isLeftOut(stored)) << stored;
}

TEST(DecodeMotion, OwnValuesKeepTheirBits) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  for (const Conventions& conventions : {Conventions{}, startingPoint("taa-inspector").conventions}) {
    const Manifest manifest = manifestOf(conventions, {4, 1});
    FramePlanes planes = planesOf(manifest);
    planes[PlaneKind::Motion] =
        planeFrom(4, 1, 2, {-0.0f, 1e-30f, nan, -inf, 65504.0f, 65504.0f, 65300.0f, 3.0f});
    const DecodedFrame frame = decode(manifest, 1, planes);
    const std::vector<float>& stored = planes[PlaneKind::Motion].image.pixels;
    for (std::size_t i = 0; i < stored.size(); ++i) {
      if (i == 2)
        EXPECT_TRUE(std::isnan(frame.motion.pixels[i]));
      else
        EXPECT_EQ(frame.motion.pixels[i], stored[i]) << i;
    }
    EXPECT_TRUE(std::signbit(frame.motion.pixels[0]));
  }
}

TEST(DecodeMotion, KeepsNanAndInfinityOfOtherConventions) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  for (const StartingPoint& point : startingPoints()) {
    const glm::vec2 px = decodedMotion(manifestOf(point.conventions, kSize), nan, inf);
    EXPECT_TRUE(std::isnan(px.x)) << point.id;
    EXPECT_TRUE(std::isinf(px.y)) << point.id;
  }
}

TEST(DecodeMotion, APlaneOfHalfTheSizeGivesTheNearestTexel) {
  const Manifest manifest = manifestOf({}, {4, 2});
  FramePlanes planes = planesOf(manifest);
  planes[PlaneKind::Motion] = planeFrom(2, 1, 2, {1.0f, 2.0f, 3.0f, 4.0f});
  const DecodedFrame frame = decode(manifest, 1, planes);
  const std::vector<float> row = {1, 2, 1, 2, 3, 4, 3, 4};
  std::vector<float> expected = row;
  expected.insert(expected.end(), row.begin(), row.end());
  EXPECT_EQ(frame.motion.pixels, expected);
  ASSERT_EQ(frame.notes.size(), 1u);
  EXPECT_NE(frame.notes[0].find("2×1"), std::string::npos);
}

TEST(DecodeMotion, ANumberThatCannotScaleIsAnError) {
  for (const double scale : {0.0, std::numeric_limits<double>::quiet_NaN()}) {
    Conventions conventions;
    conventions.motion.scale.y = scale;
    EXPECT_THROW(decodedMotion(manifestOf(conventions, kSize), 1.0f, 1.0f), Error);
  }
}

} // namespace taa::capture
