// Rounding to half floats against the definition: nearest, ties to even.
#include "core/base/Half.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace taa {
namespace {

/// All halves from 0 to 65504 in order, from exponent and fraction.
std::vector<float> allHalves() {
  std::vector<float> halves;
  for (int fraction = 0; fraction < 1024; ++fraction)
    halves.push_back(std::ldexp(static_cast<float>(fraction), -24));
  for (int exponent = -14; exponent <= 15; ++exponent) {
    for (int fraction = 0; fraction < 1024; ++fraction) {
      halves.push_back(std::ldexp(static_cast<float>(1024 + fraction), exponent - 10));
    }
  }
  return halves;
}

TEST(RoundedToHalf, KeepsEveryHalfAndSendsWhatLiesBetweenToTheNearest) {
  const std::vector<float> halves = allHalves();
  ASSERT_EQ(halves.back(), 65504.0f);
  for (std::size_t i = 0; i + 1 < halves.size(); ++i) {
    const float low = halves[i];
    const float high = halves[i + 1];
    const float middle = 0.5f * (low + high); // exact: one more bit than a half has
    ASSERT_EQ(roundedToHalf(low), low);
    ASSERT_EQ(roundedToHalf(-low), -low);
    ASSERT_EQ(roundedToHalf(std::nextafter(middle, 0.0f)), low);
    ASSERT_EQ(roundedToHalf(std::nextafter(middle, 1e6f)), high);
    ASSERT_EQ(roundedToHalf(middle), i % 2 == 0 ? low : high) << "tie between " << low << " and " << high;
  }
}

TEST(RoundedToHalf, OverflowsHalfwayToTheNextPowerOfTwo) {
  EXPECT_EQ(roundedToHalf(std::nextafter(65520.0f, 0.0f)), 65504.0f);
  EXPECT_EQ(roundedToHalf(65520.0f), std::numeric_limits<float>::infinity());
  EXPECT_EQ(roundedToHalf(-1e30f), -std::numeric_limits<float>::infinity());
  EXPECT_TRUE(std::isnan(roundedToHalf(std::nanf(""))));
  EXPECT_TRUE(std::signbit(roundedToHalf(-0.0f)));
}

/// The value of a half's bits, by its definition.
float valueOfHalf(std::uint16_t half) {
  const int exponent = (half >> 10) & 31, fraction = half & 1023;
  const float sign = half & 0x8000 ? -1.0f : 1.0f;
  if (exponent == 31) return fraction ? std::nanf("") : sign * std::numeric_limits<float>::infinity();
  if (exponent == 0) return sign * std::ldexp(static_cast<float>(fraction), -24);
  return sign * std::ldexp(static_cast<float>(1024 + fraction), exponent - 25);
}

TEST(ToHalves, GivesTheBitsOfTheRoundedValue) {
  std::vector<float> values{
      0.0f, -0.0f, 65519.99f, 65520.0f, -1e30f, 1e-9f, std::numeric_limits<float>::infinity()};
  const std::vector<float> known = allHalves();
  for (std::size_t i = 0; i + 1 < known.size(); ++i) {
    const float middle = 0.5f * (known[i] + known[i + 1]);
    for (const float value :
         {known[i], -known[i], middle, std::nextafter(middle, 0.0f), -std::nextafter(middle, 1e6f)})
      values.push_back(value);
  }
  std::vector<std::uint16_t> halves(values.size());
  toHalves(values, halves);
  for (std::size_t i = 0; i < values.size(); ++i) {
    ASSERT_EQ(valueOfHalf(halves[i]), roundedToHalf(values[i])) << values[i];
    ASSERT_EQ(std::signbit(valueOfHalf(halves[i])), std::signbit(values[i])) << values[i];
  }
}

TEST(ToHalves, KeepsWhatIsNoNumber) {
  const float values[] = {std::nanf("")};
  std::uint16_t halves[] = {0};
  toHalves(values, halves);
  EXPECT_TRUE(std::isnan(valueOfHalf(halves[0])));
}

} // namespace
} // namespace taa
