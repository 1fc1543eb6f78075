// Whether frames show a fault, on painted frames that are changed by known amounts.
#include "core/doctor/frames/ShownDifference.h"

#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <limits>

namespace taa::doctor {
namespace {

constexpr std::size_t kRegion = 48; // pixels

/// A picture at rest without jitter, whose light rises by `slope` from pixel to pixel to the right.
DoctorFrame ramp(float slope) {
  DoctorFrame frame = test::paintedFrame({}, 3);
  frame.jitterPx = glm::vec2(0.0f);
  for (float& value : frame.motionPx.pixels) value = 0.0f;
  for (int y = 0; y < frame.luma.height; ++y)
    for (int x = 0; x < frame.luma.width; ++x) *frame.luma.at(x, y) = slope * static_cast<float>(x);
  return frame;
}

/// Calls `change` with the places of `count` pixels, none of them near the border.
void forPixels(std::size_t count, const std::function<void(int x, int y)>& change) {
  for (int y = 20; y < test::kPaintedPx.y - 12; ++y)
    for (int x = 12; x < test::kPaintedPx.x - 12; ++x) {
      if (count-- == 0) return;
      change(x, y);
    }
}

/// Of a picture that rests, with `count` motions longer by `px` along x.
ShownDifference ofLonger(std::size_t count, float px, float slope = 0.05f) {
  const DoctorFrame before = ramp(slope), sound = before;
  DoctorFrame faulty = sound;
  forPixels(count, [&](int x, int y) { faulty.motionPx.at(x, y)[0] += px; });
  ShownDifference out;
  out.add({faulty, &before}, {sound, &before});
  return out;
}

/// Of frames without ones before them.
ShownDifference ofFirst(const DoctorFrame& faulty, const DoctorFrame& sound) {
  ShownDifference out;
  out.add({faulty}, {sound});
  return out;
}

} // namespace

TEST(ShownDifference, ShowsWhereARegionContradictsTheFrameBefore) {
  EXPECT_FALSE(ofLonger(0, 0.0f).shows());
  EXPECT_TRUE(ofLonger(kRegion, 0.5f).shows());
  EXPECT_FALSE(ofLonger(kRegion - 1, 0.5f).shows());
}

// A wrong motion that reads the same light is seen by nobody: over what is even, or where nothing was before.
TEST(ShownDifference, ShowsMotionWhereItReadsAnotherLight) {
  EXPECT_TRUE(ofLonger(kRegion, 0.5f, 0.025f).shows()) << "by 0.0125";
  EXPECT_FALSE(ofLonger(kRegion, 0.5f, 0.0125f).shows()) << "by 0.00625";
  EXPECT_FALSE(ofLonger(kRegion, 0.5f, 0.0f).shows());
  const DoctorFrame frame = test::paintedFrame({}, 3);
  DoctorFrame other = frame;
  for (float& value : other.motionPx.pixels) value += 4.0f;
  EXPECT_FALSE(ofFirst(frame, other).shows());
  EXPECT_GT(ofFirst(frame, other).motionPx, 0.0);
}

// Another light that stays is another picture; one that comes from frame to frame is not what was read.
TEST(ShownDifference, ShowsLightThatIsNotThatOfTheFrameBefore) {
  const DoctorFrame sound = ramp(0.05f);
  DoctorFrame lit = sound;
  forPixels(kRegion, [&](int x, int y) { *lit.luma.at(x, y) += 0.05f; });
  ShownDifference stays, comes;
  stays.add({lit, &lit}, {sound, &sound});
  comes.add({lit, &sound}, {sound, &sound});
  EXPECT_FALSE(stays.shows());
  EXPECT_TRUE(comes.shows());
  EXPECT_EQ(stays.luma, comes.luma);
}

TEST(ShownDifference, ShowsAnotherDepth) {
  DoctorFrame sound = ramp(0.05f);
  sound.depthView = sound.luma;
  for (float& value : sound.depthView.pixels) value = 8.0f;
  DoctorFrame faulty = sound;
  forPixels(kRegion, [&](int x, int y) { *faulty.depthView.at(x, y) = 8.5f; });
  EXPECT_TRUE(ofFirst(faulty, sound).shows());
  EXPECT_FALSE(ofFirst(sound, sound).shows());
}

// What a TAA makes of wrong frames follows from these; of right ones it shows what is wrong with the TAA.
TEST(ShownDifference, ShowsTheOutputWhereAllElseIsTheSame) {
  DoctorFrame frame = test::paintedFrame({}, 3);
  frame.output = Image(frame.sizePx().x, frame.sizePx().y, 3);
  DoctorFrame other = frame;
  for (float& value : other.output.pixels) value = 1.0f;
  EXPECT_TRUE(ofFirst(frame, other).shows());
  // One NaN that a resolve keeps and spreads.
  *other.luma.at(80, 48) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(ofFirst(frame, other).shows());
  *other.luma.at(80, 48) = 0.0f;
  EXPECT_TRUE(ofFirst(frame, other).shows());
  *other.motionPx.at(80, 48) += 1.0f;
  EXPECT_FALSE(ofFirst(frame, other).shows());
}

// Nothing reads motion there.
TEST(ShownDifference, LeavesOutMotionWhereHistoryStarts) {
  DoctorFrame frame = test::paintedFrame({}, 3);
  frame.startsHistory = true;
  DoctorFrame other = frame;
  for (float& value : other.motionPx.pixels) value += 4.0f;
  const DoctorFrame before = test::paintedFrame({}, 2);
  ShownDifference out;
  out.add({other, &before}, {frame, &before});
  EXPECT_FALSE(out.shows());
  EXPECT_EQ(out.motionPx, 0.0);
}

TEST(ShownDifference, ShowsWhereJitterDiffers) {
  const DoctorFrame frame = test::paintedFrame({}, 3);
  DoctorFrame other = frame;
  other.jitterPx.x += 0.25f;
  const ShownDifference out = ofFirst(other, frame);
  EXPECT_TRUE(out.shows());
  EXPECT_EQ(out.jitterPx, 0.25);
  EXPECT_EQ(out.luma, 0.0);
}

TEST(ShownDifference, IsTheMeanOverThePixels) {
  const double pixels = static_cast<double>(test::kPaintedPx.x) * test::kPaintedPx.y;
  EXPECT_NEAR(ofLonger(100, 0.5f).motionPx, 50.0 / pixels, 1e-6);
}

TEST(ShownDifference, IsSmallBesideOneThatIsTenTimesAsLarge) {
  const auto all = static_cast<std::size_t>(test::kPaintedPx.x) * 20;
  EXPECT_TRUE(ofLonger(all, 0.5f).isSmallBeside(ofLonger(all, 8.0f)));
  EXPECT_FALSE(ofLonger(all, 8.0f).isSmallBeside(ofLonger(all, 0.5f)));
}

} // namespace taa::doctor
