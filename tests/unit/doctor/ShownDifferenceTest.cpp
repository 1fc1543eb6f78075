// Whether frames show a fault, on painted frames that are changed by known amounts.
#include "core/doctor/frames/ShownDifference.h"

#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>

namespace taa::doctor {
namespace {

constexpr std::size_t kRegion = 48; // pixels

/// A picture whose light rises by `slope` from pixel to pixel to the right.
DoctorFrame ramp(float slope) {
  DoctorFrame frame = test::paintedFrame({}, 2);
  for (int y = 0; y < frame.luma.height; ++y)
    for (int x = 0; x < frame.luma.width; ++x) *frame.luma.at(x, y) = slope * static_cast<float>(x);
  return frame;
}

/// Of a frame and itself with `count` motions longer by `px` along x, from the middle row on, where a frame
/// before of that slope is read.
ShownDifference ofLonger(std::size_t count, float px, float slope = 0.05f) {
  DoctorFrame frame = test::paintedFrame({}, 3);
  for (float& value : frame.motionPx.pixels) value = 0.0f;
  DoctorFrame other = frame;
  std::size_t left = count;
  for (int y = frame.sizePx().y / 4; y < frame.sizePx().y && left > 0; ++y)
    for (int x = 12; x < frame.sizePx().x - 12 && left > 0; ++x, --left) other.motionPx.at(x, y)[0] += px;
  const DoctorFrame before = ramp(slope);
  ShownDifference out;
  out.add(other, frame, &before);
  return out;
}

} // namespace

TEST(ShownDifference, ShowsWhereARegionDiffersByWhatOneSees) {
  EXPECT_FALSE(ofLonger(0, 0.0f).shows());
  EXPECT_TRUE(ofLonger(kRegion, 0.5f).shows());
  EXPECT_FALSE(ofLonger(kRegion - 1, 0.5f).shows());
  EXPECT_FALSE(ofLonger(kRegion, 0.125f).shows());
}

// A wrong motion that reads the same light is seen by nobody: over what is even, or where nothing was before.
TEST(ShownDifference, ShowsMotionWhereItReadsAnotherLight) {
  EXPECT_TRUE(ofLonger(kRegion, 0.5f, 0.025f).shows()) << "by 0.0125";
  EXPECT_FALSE(ofLonger(kRegion, 0.5f, 0.0125f).shows()) << "by 0.00625";
  EXPECT_FALSE(ofLonger(kRegion, 0.5f, 0.0f).shows());
  const DoctorFrame frame = test::paintedFrame({}, 3);
  DoctorFrame other = frame;
  for (float& value : other.motionPx.pixels) value += 4.0f;
  ShownDifference first;
  first.add(frame, other, nullptr);
  EXPECT_FALSE(first.shows());
  EXPECT_GT(first.motionPx, 0.0);
}

// What a TAA makes of wrong frames follows from these; of right ones it shows what is wrong with the TAA.
TEST(ShownDifference, ShowsTheOutputWhereAllElseIsTheSame) {
  DoctorFrame frame = test::paintedFrame({}, 3);
  frame.output = Image(frame.sizePx().x, frame.sizePx().y, 3);
  DoctorFrame other = frame;
  for (float& value : other.output.pixels) value = 1.0f;
  ShownDifference output;
  output.add(frame, other, nullptr);
  EXPECT_TRUE(output.shows());
  // One NaN that a resolve keeps and spreads.
  *other.luma.at(80, 48) = std::numeric_limits<float>::quiet_NaN();
  ShownDifference kept;
  kept.add(frame, other, nullptr);
  EXPECT_TRUE(kept.shows());
  *other.motionPx.at(80, 48) += 1.0f;
  ShownDifference motion;
  motion.add(frame, other, nullptr);
  EXPECT_FALSE(motion.shows());
}

// Nothing reads motion there.
TEST(ShownDifference, LeavesOutMotionWhereHistoryStarts) {
  DoctorFrame frame = test::paintedFrame({}, 3);
  frame.startsHistory = true;
  DoctorFrame other = frame;
  for (float& value : other.motionPx.pixels) value += 4.0f;
  const DoctorFrame before = test::paintedFrame({}, 2);
  ShownDifference out;
  out.add(frame, other, &before);
  EXPECT_FALSE(out.shows());
  EXPECT_EQ(out.motionPx, 0.0);
}

TEST(ShownDifference, ShowsWhereJitterDiffers) {
  const DoctorFrame frame = test::paintedFrame({}, 3);
  DoctorFrame other = frame;
  other.jitterPx.x += 0.25f;
  ShownDifference out;
  out.add(frame, other, nullptr);
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
