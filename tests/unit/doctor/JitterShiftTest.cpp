// The shift of a picture against the one before it, measured in frames whose jitter is known.
#include "core/doctor/jitter/JitterShift.h"

#include "tests/support/doctor/PaintedFrames.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace taa::doctor {
namespace {

// px: reading between pixels softens, which pulls a least-squares fit a little.
constexpr float kMeasuredTo = 0.04f;

float missOf(const DoctorFrame& before, const DoctorFrame& now) {
  const FrameNeighbors frames{now, before, nullptr};
  const auto shift = measureShift(shiftSamples(frames).world, frames);
  if (!shift) return 99.0f;
  return glm::distance(*shift, test::paintedFrame({}, now.frame - 1).jitterPx - now.jitterPx);
}

} // namespace

TEST(JitterShift, IsThatOfBothJitters) {
  for (int frame = 1; frame < 8; ++frame)
    EXPECT_LT(missOf(test::paintedFrame({}, frame - 1), test::paintedFrame({}, frame)), kMeasuredTo) << frame;
}

TEST(JitterShift, RestsOnNoMotionVectorWhereCamerasAreKnown) {
  DoctorFrame now = test::paintedFrame({}, 3);
  for (float& value : now.motionPx.pixels) value = 17.0f;
  EXPECT_LT(missOf(test::paintedFrame({}, 2), now), kMeasuredTo);
}

TEST(JitterShift, TakesMotionVectorsWhereCamerasAreNotKnown) {
  DoctorFrame now = test::paintedFrame({}, 3);
  now.previousClipFromClip.reset();
  EXPECT_LT(missOf(test::paintedFrame({}, 2), now), kMeasuredTo);
}

TEST(JitterShift, LooksAtAllPixelsWhereFewHaveDetail) {
  // Twice as wide and as high: a grid with gaps, of which a stripe has detail.
  DoctorFrame wide;
  wide.luma = Image(2 * test::kPaintedPx.x, 2 * test::kPaintedPx.y, 1);
  wide.motionPx = Image(wide.luma.width, wide.luma.height, 2);
  const auto stripe = [&](int rows) {
    DoctorFrame out = wide;
    for (int y = 20; y < 20 + rows; ++y)
      for (int x = 20; x < 140; ++x) *out.luma.at(x, y) = (x / 3 + y / 2) % 2 == 0 ? 0.25f : 0.75f;
    return shiftSamples({out, out, nullptr});
  };
  const ShiftSamples few = stripe(2), many = stripe(40);
  EXPECT_TRUE(few.isSparse);
  EXPECT_TRUE(areEnough(few.world));
  EXPECT_FALSE(many.isSparse);
  EXPECT_TRUE(areEnough(many.world));
}

TEST(JitterShift, IsNotKnownWithoutDetail) {
  DoctorFrame now = test::paintedFrame({}, 3);
  for (float& value : now.luma.pixels) value = 0.5f;
  const DoctorFrame before = test::paintedFrame({}, 2);
  const FrameNeighbors frames{now, before, nullptr};
  const ShiftSamples samples = shiftSamples(frames);
  EXPECT_FALSE(areEnough(samples.world));
  EXPECT_FALSE(measureShift(samples.world, frames));
}

TEST(JitterShift, LeavesLeastWherePicturesAreShiftedAsTheyWereDrawn) {
  const DoctorFrame now = test::paintedFrame({}, 3), before = test::paintedFrame({}, 2);
  const FrameNeighbors frames{now, before, nullptr};
  const std::vector<SearchedPixel> samples = shiftSamples(frames).world;
  const double right = lumaLeft(samples, before.luma, frames.jitterStep());
  EXPECT_LT(2.0 * right, lumaLeft(samples, before.luma, glm::vec2(0.0f)));
  EXPECT_LT(2.0 * right, lumaLeft(samples, before.luma, -frames.jitterStep()));
}

TEST(JitterShift, SamplesTheSkyApart) {
  const DoctorFrame now = test::paintedFrame({}, 3), before = test::paintedFrame({}, 2);
  const ShiftSamples samples = shiftSamples({now, before, nullptr});
  EXPECT_LT(samples.sky.size(), 400u); // it is plain but at the horizon
  std::size_t sky = 0;
  for (const float depth : now.depth.pixels) sky += depth == 0.0f ? 1 : 0;
  EXPECT_NEAR(samples.skyShare, static_cast<double>(sky) / static_cast<double>(now.depth.pixels.size()),
              1e-9);
}

} // namespace taa::doctor
