// Motion that is made of depth and cameras, of a still scene whose points are projected by hand.
#include "core/capture/decode/DecodedFrame.h"
#include "core/render/FrameInputs.h"
#include "tests/unit/capture/CaptureFixtures.h"

#include <glm/vec3.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

namespace taa::capture {
namespace {

// Slopes 1 and 2: at 5 m the picture of 200 × 100 px is 10 m wide and 5 m high, 20 px a meter both ways.
constexpr glm::ivec2 kSize(200, 100);
constexpr double kNear = 0.1;

/// Two frames, the camera of frame 0 at `from` and that of frame 1 at `to`, looking along −z.
Manifest movedBy(const glm::dvec3& from, const glm::dvec3& to) {
  Manifest manifest = manifestOf({}, kSize);
  for (CapturedFrame& frame : manifest.frames) frame.projection = projections::reversed(1, 2, kNear);
  manifest.frames[0].view = moveBy(-from.x, -from.y, -from.z);
  manifest.frames[1].view = moveBy(-to.x, -to.y, -to.z);
  return manifest;
}

/// Frame 1 with a wall at 5 m, whose right half is sky.
DecodedFrame decoded(const Manifest& manifest) {
  FramePlanes planes = planesOf(manifest);
  PlaneData depth = planeFrom(kSize.x, kSize.y, 1, {static_cast<float>(kNear / 5.0)});
  for (int y = 0; y < kSize.y; ++y)
    for (int x = kSize.x / 2; x < kSize.x; ++x) *depth.image.at(x, y) = 0.0f;
  planes[PlaneKind::Depth] = depth;
  return decode(manifest, 1, planes);
}

glm::vec2 motionAt(const DecodedFrame& frame, int x, int y) {
  return {frame.motion.at(x, y)[0], frame.motion.at(x, y)[1]};
}

} // namespace

TEST(DecodeCameraMotion, AWallMovesAgainstTheCamera) {
  // 0.1 m to the right and 0.05 m up: content goes 2 px to the left and 1 px down.
  const DecodedFrame frame = decoded(movedBy({0, 0, 0}, {0.1, 0.05, 0}));
  for (int y = 0; y < kSize.y; ++y)
    for (int x = 0; x < kSize.x; ++x) {
      const glm::vec2 px = motionAt(frame, x, y);
      const bool isSky = x >= kSize.x / 2;
      // The stored depth is a float: 6e-8 of 2 px.
      ASSERT_NEAR(px.x, isSky ? 0.0f : -2.0f, 1e-6f) << x << ", " << y;
      ASSERT_NEAR(px.y, isSky ? 0.0f : 1.0f, 1e-6f) << x << ", " << y;
    }
}

TEST(DecodeCameraMotion, AWallComesNearerAroundTheMiddle) {
  // From 6 m to 5 m: what lies r px from the middle was at r · 5/6.
  const DecodedFrame frame = decoded(movedBy({0, 0, 1}, {0, 0, 0}));
  for (const int x : {0, 40, 99}) {
    const float fromMiddle = static_cast<float>(x) + 0.5f - 100.0f;
    EXPECT_NEAR(motionAt(frame, x, 20).x, fromMiddle / 6.0f, 1e-5f);
    EXPECT_NEAR(motionAt(frame, x, 20).y, (20.5f - 50.0f) / 6.0f, 1e-5f);
    EXPECT_NEAR(*frame.previousDepth.at(x, 20), 6.0f, 1e-5f);
  }
  EXPECT_EQ(*frame.previousDepth.at(150, 20), 0.0f) << "the sky has none";
}

TEST(DecodeCameraMotion, WhatWasBehindTheCameraHasNoPreviousPosition) {
  // The wall is at z = −5, and the camera was at −10.
  const DecodedFrame frame = decoded(movedBy({0, 0, -10}, {0, 0, 0}));
  EXPECT_EQ(motionAt(frame, 40, 20), glm::vec2(kNoPreviousPosition));
  EXPECT_EQ(*frame.previousDepth.at(40, 20), 0.0f);
  EXPECT_EQ(motionAt(frame, 150, 20), glm::vec2(0.0f)) << "the sky is as far as before";
}

TEST(DecodeCameraMotion, TheSkyTurnsWithTheCamera) {
  Manifest manifest = movedBy({0, 0, 0}, {0, 0, 0});
  const double angle = 0.05, c = std::cos(angle), s = std::sin(angle);
  // The previous camera was turned to the left: what it saw at an angle of a is seen at a − 0.05.
  manifest.frames[1].previousView = StatedMatrix{c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0, 0, 0, 0, 1};
  const DecodedFrame frame = decoded(manifest);
  for (const int x : {100, 150, 199}) {
    const double slope = (x + 0.5 - 100.0) / 100.0; // tangent of the angle to the right
    const double before = std::tan(std::atan(slope) - angle);
    EXPECT_NEAR(motionAt(frame, x, 49).x, 100.0 * (slope - before), 1e-4) << x;
  }
}

TEST(DecodeCameraMotion, ACameraThatRestsMovesNothing) {
  const DecodedFrame frame = decoded(movedBy({0.3, 7, -2}, {0.3, 7, -2}));
  for (const float value : frame.motion.pixels) ASSERT_EQ(value, 0.0f);
}

TEST(DecodeCameraMotion, JitteredDepthIsOfTheJitteredPlace) {
  // Coming from 6 m: what pixel x shows lies at x + ½ − j.
  Manifest manifest = movedBy({0, 0, 1}, {0, 0, 0});
  manifest.frames[1].jitter = {0.5, -0.25};
  DecodedFrame frame = decoded(manifest);
  EXPECT_NEAR(motionAt(frame, 40, 20).x, (40.0f - 100.0f) / 6.0f, 1e-5f);
  EXPECT_NEAR(motionAt(frame, 40, 20).y, (20.75f - 50.0f) / 6.0f, 1e-5f);
  manifest.conventions.depth.jittered = false;
  frame = decoded(manifest);
  EXPECT_NEAR(motionAt(frame, 40, 20).x, (40.5f - 100.0f) / 6.0f, 1e-5f);
}

TEST(DecodeCameraMotion, FillsInWhereItIsStated) {
  Manifest manifest = movedBy({0, 0, 0}, {0.1, 0.05, 0});
  FramePlanes planes = planesOf(manifest);
  planes[PlaneKind::Depth] = planeFrom(kSize.x, kSize.y, 1, {static_cast<float>(kNear / 5.0), 0.0f});
  planes[PlaneKind::Motion] = planeFrom(kSize.x, kSize.y, 2, {4.0f, 4.0f, 9.0f, 9.0f});
  manifest.conventions.motion.includesCamera = false;
  DecodedFrame frame = decode(manifest, 1, planes);
  EXPECT_NEAR(motionAt(frame, 10, 3).x, 4.0f - 2.0f, 1e-6f);
  EXPECT_NEAR(motionAt(frame, 10, 3).y, 4.0f + 1.0f, 1e-6f);
  manifest.conventions.motion.includesCamera = true;
  manifest.conventions.motion.whereNothing = MotionFallback::Camera;
  frame = decode(manifest, 1, planes);
  EXPECT_EQ(motionAt(frame, 10, 3), glm::vec2(4.0f));
  EXPECT_EQ(motionAt(frame, 11, 3), glm::vec2(0.0f)) << "the sky does not move with the camera";
  manifest.conventions.motion.whereNothing = MotionFallback::None;
  frame = decode(manifest, 1, planes);
  EXPECT_EQ(motionAt(frame, 11, 3), glm::vec2(kNoPreviousPosition));
  manifest.conventions.motion.notWritten = 4.0;
  frame = decode(manifest, 1, planes);
  EXPECT_NEAR(motionAt(frame, 10, 3).x, -2.0f, 1e-6f);
}

TEST(DecodeCameraMotion, NanDepthHasNoPreviousPosition) {
  Manifest manifest = movedBy({0, 0, 0}, {0.1, 0, 0});
  FramePlanes planes = planesOf(manifest);
  planes[PlaneKind::Depth] = planeFrom(kSize.x, kSize.y, 1, {std::nanf("")});
  const DecodedFrame frame = decode(manifest, 1, planes);
  EXPECT_TRUE(std::isnan(frame.depth.pixels[0]));
  EXPECT_EQ(motionAt(frame, 0, 0), glm::vec2(kNoPreviousPosition));
  EXPECT_EQ(frame.previousDepth.pixels[0], 0.0f);
}

TEST(DecodeCameraMotion, ThereIsNoneWithoutDepthOrMatrices) {
  Manifest manifest = movedBy({0, 0, 0}, {0.1, 0, 0});
  EXPECT_TRUE(decode(manifest, 1, planesOf(manifest)).motion.empty());
  for (CapturedFrame& frame : manifest.frames) frame.view = {};
  const DecodedFrame frame = decoded(manifest);
  EXPECT_TRUE(frame.motion.empty());
  EXPECT_TRUE(frame.previousDepth.empty());
  EXPECT_FALSE(frame.camera || frame.previousCamera);
}

} // namespace taa::capture
