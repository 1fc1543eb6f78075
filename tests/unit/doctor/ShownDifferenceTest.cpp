// Whether frames show a fault, on painted frames that are changed by known amounts.
#include "core/doctor/frames/ShownDifference.h"

#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace taa::doctor {
namespace {

constexpr std::size_t kRegion = 48; // pixels

/// Of a frame and itself with the first `count` motions longer by `px` along x.
ShownDifference ofLonger(std::size_t count, float px) {
  const DoctorFrame frame = test::paintedFrame({}, 3);
  DoctorFrame other = frame;
  for (std::size_t i = 0; i < count; ++i) other.motionPx.pixels[2 * i] += px;
  ShownDifference out;
  out.add(frame, other);
  return out;
}

} // namespace

TEST(ShownDifference, ShowsWhereARegionDiffersByWhatOneSees) {
  EXPECT_FALSE(ofLonger(0, 0.0f).shows());
  EXPECT_TRUE(ofLonger(kRegion, 0.5f).shows());
  EXPECT_FALSE(ofLonger(kRegion - 1, 0.5f).shows());
  EXPECT_FALSE(ofLonger(kRegion, 0.125f).shows());
}

// Nothing reads motion there.
TEST(ShownDifference, LeavesOutMotionWhereHistoryStarts) {
  DoctorFrame frame = test::paintedFrame({}, 3);
  frame.startsHistory = true;
  DoctorFrame other = frame;
  for (float& value : other.motionPx.pixels) value += 4.0f;
  ShownDifference out;
  out.add(frame, other);
  EXPECT_FALSE(out.shows());
  EXPECT_EQ(out.motionPx, 0.0);
}

TEST(ShownDifference, ShowsWhereJitterDiffers) {
  const DoctorFrame frame = test::paintedFrame({}, 3);
  DoctorFrame other = frame;
  other.jitterPx.x += 0.25f;
  ShownDifference out;
  out.add(frame, other);
  EXPECT_TRUE(out.shows());
  EXPECT_EQ(out.jitterPx, 0.25);
  EXPECT_EQ(out.luma, 0.0);
}

TEST(ShownDifference, IsTheMeanOverThePixels) {
  const DoctorFrame frame = test::paintedFrame({}, 3);
  const double pixels = static_cast<double>(frame.luma.width) * frame.luma.height;
  EXPECT_NEAR(ofLonger(100, 0.5f).motionPx, 50.0 / pixels, 1e-6);
}

TEST(ShownDifference, IsSmallBesideOneThatIsTenTimesAsLarge) {
  const auto all = static_cast<std::size_t>(test::paintedFrame({}, 3).sizePx().x) * 20;
  EXPECT_TRUE(ofLonger(all, 0.5f).isSmallBeside(ofLonger(all, 8.0f)));
  EXPECT_FALSE(ofLonger(all, 8.0f).isSmallBeside(ofLonger(all, 0.5f)));
}

} // namespace taa::doctor
