// What values of an output say by themselves, on frames of a few pixels.
#include "core/doctor/resolve/OutputValues.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>

namespace taa::doctor {
namespace {

constexpr int kSide = 40;

/// Colors of no steps, and an output that holds them in so many, or as they are where that is 0.
DoctorFrame steppedFrame(int number, float steps) {
  DoctorFrame out;
  out.frame = number;
  out.color = out.output = Image(kSide, kSide, 3);
  out.motionPx = Image(kSide, kSide, 2);
  for (std::size_t i = 0; i < out.color.pixels.size(); ++i) {
    const float value = 0.1f + 0.8f * static_cast<float>(i) / static_cast<float>(out.color.pixels.size());
    out.color.pixels[i] = value;
    out.output.pixels[i] = steps > 0.0f ? std::round(value * steps) / steps : value;
  }
  return out;
}

} // namespace

TEST(OutputValues, TellEightBitsFromMore) {
  for (const float steps : {0.0f, 1023.0f, 255.0f}) {
    OutputValues values;
    values.add(steppedFrame(0, steps), nullptr);
    EXPECT_EQ(values.isOfFewBits(), steps == 255.0f) << steps;
    EXPECT_EQ(values.values, std::size_t{3 * kSide * kSide});
  }
}

TEST(OutputValues, SayNothingOfFewBitsWhereColorsHaveNoMore) {
  DoctorFrame frame = steppedFrame(0, 255.0f);
  frame.color = frame.output;
  OutputValues values;
  values.add(frame, nullptr);
  EXPECT_FALSE(values.isOfFewBits());
}

TEST(OutputValues, CountWhatIsNoNumberUnlessColorsAreNone) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  OutputValues values;
  for (int number = 0; number < 3; ++number) {
    DoctorFrame frame = steppedFrame(number, 0.0f);
    frame.output.at(5, 6)[0] = kNan;
    if (number < 2) frame.color.at(6, 7)[2] = kNan; // beside it
    values.add(frame, nullptr);
  }
  EXPECT_EQ(values.spoiledFrames, 1);
  EXPECT_EQ(values.firstFrame, 2);
  EXPECT_EQ(values.mostPixel, glm::ivec2(5, 6));
  EXPECT_FALSE(values.keepsNan());
  DoctorFrame frame = steppedFrame(3, 0.0f);
  frame.output.at(9, 9)[0] = frame.output.at(9, 10)[0] = kNan;
  values.add(frame, nullptr);
  EXPECT_TRUE(values.keepsNan());
  EXPECT_EQ(values.most, 2u);
  EXPECT_EQ(values.mostFrame, 3);
}

TEST(OutputValues, CountValuesThatStayThoughTheFrameWantsOthers) {
  DoctorFrame before = steppedFrame(0, 255.0f), frame = before;
  frame.frame = 1;
  for (float& color : frame.color.pixels) color += 2.0f / 255.0f;
  frame.output.at(0, 0)[0] += 1.0f / 255.0f;
  OutputValues values;
  values.add(frame, &before);
  // The rounding of the output is half a step at most, so that all are off by one and a half to two and a
  // half.
  EXPECT_EQ(values.resting, std::size_t{3 * kSide * kSide});
  EXPECT_EQ(values.stuck, std::size_t{3 * kSide * kSide - 1});
}

} // namespace taa::doctor
