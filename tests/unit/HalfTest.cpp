// Rounding to half floats against the definition: nearest, ties to even.
#include "core/base/Half.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <vector>

namespace taa {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

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

TEST(Halves, HaveTheValuesOfIeee754) {
  EXPECT_EQ(floatOfHalf(0x3c00), 1.0f);
  EXPECT_EQ(floatOfHalf(0xc000), -2.0f);
  EXPECT_EQ(floatOfHalf(0x3555), 0.333251953125f);        // (1 + 0x155 / 1024) / 4
  EXPECT_EQ(floatOfHalf(0x7bff), 65504.0f);               // the largest
  EXPECT_EQ(floatOfHalf(0x0400), 6.103515625e-5f);        // the smallest normal one, 2⁻¹⁴
  EXPECT_EQ(floatOfHalf(0x0001), 5.9604644775390625e-8f); // the smallest of all, 2⁻²⁴
  EXPECT_EQ(floatOfHalf(0x83ff), -1023.0f * 5.9604644775390625e-8f);
  EXPECT_EQ(floatOfHalf(0x7c00), kInfinity);
  EXPECT_EQ(floatOfHalf(0xfc00), -kInfinity);
  EXPECT_TRUE(std::isnan(floatOfHalf(0x7e00)) && std::isnan(floatOfHalf(0xfc01)));
  EXPECT_TRUE(std::signbit(floatOfHalf(0x8000)));
}

TEST(Halves, EveryOneIsItsFormula) {
  for (unsigned bits = 0; bits < 0x7c00; ++bits) {
    const int exponent = static_cast<int>(bits >> 10u), fraction = static_cast<int>(bits & 0x3ffu);
    const double value =
        exponent > 0 ? std::ldexp(1024 + fraction, exponent - 25) : std::ldexp(fraction, -24);
    ASSERT_EQ(floatOfHalf(static_cast<std::uint16_t>(bits)), static_cast<float>(value)) << bits;
    ASSERT_EQ(floatOfHalf(static_cast<std::uint16_t>(bits | 0x8000u)), static_cast<float>(-value)) << bits;
    ASSERT_EQ(halfOf(static_cast<float>(value)), bits);
    ASSERT_EQ(halfOf(static_cast<float>(-value)), bits | 0x8000u);
  }
}

TEST(Halves, AreRoundedToTheNearestEven) {
  EXPECT_EQ(halfOf(1.0f + 1.0f / 2048.0f), 0x3c00); // halfway, to the even one below
  EXPECT_EQ(halfOf(1.0f + 3.0f / 2048.0f), 0x3c02); // halfway, to the even one above
  EXPECT_EQ(halfOf(1.0f + 1.1f / 2048.0f), 0x3c01);
  EXPECT_EQ(halfOf(65519.0f), 0x7bff);
  EXPECT_EQ(halfOf(65520.0f), 0x7c00);
  EXPECT_EQ(halfOf(-kInfinity), 0xfc00);
  EXPECT_TRUE(std::isnan(floatOfHalf(halfOf(std::nanf("")))));
  EXPECT_EQ(halfOf(6.1e-5f), 0x03ff); // 1023.41 steps of 2⁻²⁴
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
  EXPECT_EQ(roundedToHalf(65520.0f), kInfinity);
  EXPECT_EQ(roundedToHalf(-1e30f), -kInfinity);
  EXPECT_TRUE(std::isnan(roundedToHalf(std::nanf(""))));
  EXPECT_TRUE(std::signbit(roundedToHalf(-0.0f)));
}

TEST(ToHalves, GivesTheBitsOfEach) {
  const float tie = 1.0f + 0x1p-11f; // between 1 and the next half: to the even one
  const float values[] = {-0.0f, 1.0f, tie, -65519.0f, 65520.0f, 0x1p-24f, -std::nanf("")};
  std::array<std::uint16_t, std::size(values)> halves{};
  toHalves(values, halves);
  EXPECT_EQ(halves, (std::array<std::uint16_t, 7>{0x8000, 0x3c00, 0x3c00, 0xfbff, 0x7c00, 0x0001, 0xfe00}));
}

} // namespace
} // namespace taa
