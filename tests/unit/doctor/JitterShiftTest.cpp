// The shift of a picture against the one before it, measured in frames whose jitter is known.
#include "core/doctor/jitter/JitterShift.h"

#include "tests/support/doctor/PaintedFrames.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

namespace taa::doctor {
namespace {

// px: reading between pixels softens, which pulls a least-squares fit a little.
constexpr float kMeasuredTo = 0.04f;

float missOf(const DoctorFrame& before, const DoctorFrame& now) {
  const auto shift = measureShift({now, before, nullptr});
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

TEST(JitterShift, IsNotKnownWithoutDetail) {
  DoctorFrame now = test::paintedFrame({}, 3);
  for (float& value : now.luma.pixels) value = 0.5f;
  EXPECT_FALSE(measureShift({now, test::paintedFrame({}, 2), nullptr}));
}

} // namespace taa::doctor
