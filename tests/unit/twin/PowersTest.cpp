// Powers and logarithms against those in double; each bound is counted in roundings of u = 2⁻²⁴ of the value.
#include "core/taa/twin/Powers.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>

namespace taa::twin {
namespace {

constexpr double kUnit = 0x1p-24;
constexpr std::uint32_t kMinNormal = 0x00800000, kInfinity = 0x7F800000;

/// Calls `check` with floats of `from` to `to`, by bits, every `step`-th.
template <typename Check>
void eachFloat(float from, float to, std::uint32_t step, Check check) {
  for (auto bits = std::bit_cast<std::uint32_t>(from); bits <= std::bit_cast<std::uint32_t>(to); bits += step)
    check(std::bit_cast<float>(bits));
}

/// |value/expected − 1|, 0 where both are 0.
double error(float value, double expected) {
  if (expected == 0.0) return value == 0.0f ? 0.0 : 1.0;
  return std::fabs(static_cast<double>(value) / expected - 1.0);
}

// t has 2 roundings (m − 1 is exact), the series about 2.2, their product 1: 5.2 u while the exponent is 0.
// Else the whole is ½ at least, what is added to the exponent ½ at most, and the sum is rounded once more.
TEST(Powers, LogarithmIsWithinItsBoundOverAllMagnitudes) {
  const auto check = [](float x) {
    ASSERT_LE(error(log2Of(x), std::log2(static_cast<double>(x))), 6.2 * kUnit) << x;
  };
  eachFloat(std::bit_cast<float>(kMinNormal), std::numeric_limits<float>::max(), 3001, check);
  eachFloat(0.999f, 1.001f, 1, check); // where PQ's large power would show it
}

// The sum 1 + x has a rounding, 1.45 u in the logarithm, which from √2 on is ½ at least.
TEST(Powers, LogarithmOfOnePlusKeepsSmallNumbers) {
  eachFloat(0x1p-40f, 1e30f, 1009, [](float x) {
    const double expected = std::log1p(static_cast<double>(x)) / std::numbers::ln2;
    ASSERT_LE(error(log2OfOnePlus(x), expected), 9.1 * kUnit) << x;
  });
  EXPECT_EQ(log2OfOnePlus(0.0f), 0.0f);
  for (int n = 1; n < 24; ++n) EXPECT_EQ(log2OfOnePlus(std::ldexp(1.0f, n) - 1.0f), static_cast<float>(n));
}

// What is added to 1 has 3.5 roundings of less than ½, the sum 1.
TEST(Powers, PowerOfTwoIsWithinItsBound) {
  for (double x = -126.0; x <= 127.0; x += 1.37e-3) {
    const auto near = static_cast<float>(x);
    ASSERT_LE(error(exp2Of(near), std::exp2(static_cast<double>(near))), 2.2 * kUnit) << near;
  }
  eachFloat(0x1p-30f, 2.0f, 509, [](float x) {
    ASSERT_LE(error(exp2Of(x), std::exp2(static_cast<double>(x))), 2.2 * kUnit) << x;
    ASSERT_LE(error(exp2Of(-x), std::exp2(static_cast<double>(-x))), 2.2 * kUnit) << -x;
  });
}

// Near 0 only those 3.5 roundings; above ½ they belong to 2·0.293 in a result of 0.414, and the sum adds 1.
TEST(Powers, PowerOfTwoLessOneKeepsSmallNumbers) {
  eachFloat(0x1p-40f, 100.0f, 1009, [](float x) {
    const double expected = std::expm1(static_cast<double>(x) * std::numbers::ln2);
    ASSERT_LE(error(exp2LessOne(x), expected), (x < 0.5f ? 3.5 : 6.0) * kUnit) << x;
  });
  EXPECT_EQ(exp2LessOne(0.0f), 0.0f);
  for (int n = 1; n < 24; ++n) EXPECT_EQ(exp2LessOne(static_cast<float>(n)), std::ldexp(1.0f, n) - 1.0f);
}

TEST(Powers, PowersOfTwoAreExact) {
  for (int n = -126; n <= 127; ++n) {
    EXPECT_EQ(log2Of(std::ldexp(1.0f, n)), static_cast<float>(n));
    EXPECT_EQ(exp2Of(static_cast<float>(n)), std::ldexp(1.0f, n));
    EXPECT_EQ(power(2.0f, static_cast<float>(n)), std::ldexp(1.0f, n));
  }
}

// The exponent has 6.2 roundings and its product 1, of which the power sees ln 2.
TEST(Powers, PowersAreWithinTheirBound) {
  std::mt19937 random(84);
  std::uniform_real_distribution<double> logarithm(-120.0, 120.0), share(-1.0, 1.0);
  for (int i = 0; i < 200000; ++i) {
    const auto x = static_cast<float>(std::exp2(logarithm(random)));
    const double log = std::log2(static_cast<double>(x));
    const auto e = static_cast<float>(120.0 * share(random) / std::fabs(log));
    const double exponent = static_cast<double>(e) * log;
    if (std::fabs(exponent) > 125.0) continue;
    const double bound = (2.2 + 7.2 * std::numbers::ln2 * std::fabs(exponent)) * kUnit;
    ASSERT_LE(error(power(x, e), std::pow(static_cast<double>(x), static_cast<double>(e))), bound)
        << x << "^" << e;
  }
}

TEST(Powers, TheyNeverFall) {
  float before = -200.0f;
  eachFloat(std::bit_cast<float>(kMinNormal), std::numeric_limits<float>::max(), 4099, [&](float x) {
    const float value = log2Of(x);
    ASSERT_GE(value, before) << x;
    before = value;
  });
  before = 0.0f;
  for (float x = -130.0f; x < 130.0f; x += 0x1p-9f) {
    const float value = exp2Of(x);
    ASSERT_GE(value, before) << x;
    before = value;
  }
}

TEST(Powers, WhatLiesOutsideHasAValueToo) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::bit_cast<float>(kInfinity);
  EXPECT_EQ(exp2Of(-126.5f), 0.0f);
  EXPECT_EQ(exp2Of(-infinity), 0.0f);
  EXPECT_EQ(exp2Of(nan), 0.0f);
  EXPECT_EQ(exp2Of(200.0f), 0x1p127f);
  EXPECT_EQ(exp2Of(infinity), 0x1p127f);
  EXPECT_EQ(exp2LessOne(-infinity), -1.0f);
  for (const float x : {0.0f, -0.0f, -1.0f, -infinity, nan, 1e-38f, 1e-45f})
    EXPECT_EQ(power(x, 0.5f), 0.0f) << x;
  EXPECT_EQ(power(0.25f, 0.0f), 1.0f);
}

} // namespace
} // namespace taa::twin
