// The curves that compress a channel against published values, and their ways back (invariant 57).
#include "core/taa/twin/ToneCurves.h"

#include "core/taa/twin/Color.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

namespace taa::twin {
namespace {

/// SMPTE ST 2084 in double.
double pqInDouble(double c) {
  const double root = std::pow(c / 10000.0, 2610.0 / 16384.0);
  const double fraction = (3424.0 / 4096.0 + 2413.0 / 128.0 * root) / (1.0 + 2392.0 / 128.0 * root);
  return std::pow(fraction, 2523.0 / 32.0);
}

/// From the least half float to the largest, 64 an octave.
template <typename Check>
void eachLevel(Check check) {
  for (int i = -24 * 64; i <= 16 * 64; ++i) {
    const double level = std::exp2(i / 64.0);
    check(static_cast<float>(level < 65504.0 ? level : 65504.0));
  }
}

// Techniques: 9.6, 15.5.
TEST(ToneCurves, PqHasThePublishedValues) {
  // ST 2084: code values of 100, 1000 and 10000 cd/m² to six places.
  EXPECT_NEAR(pq(100.0f), 0.508078, 5e-7);
  EXPECT_NEAR(pq(1000.0f), 0.751827, 5e-7);
  EXPECT_EQ(pq(10000.0f), 1.0f);
  EXPECT_NEAR(pq(0.0f), std::pow(0.8359375, 78.84375), 1e-11);
  EXPECT_EQ(inversePq(pq(0.0f)), 0.0f);
  EXPECT_NEAR(pq(65504.0f), 1.18777, 5e-6) << "goes on beyond 1";
  // The exponent is m₂ times a logarithm of 6.2 roundings, −20 at most; the root shifts it by less.
  eachLevel([](float c) {
    const double expected = pqInDouble(static_cast<double>(c));
    ASSERT_NEAR(static_cast<double>(pq(c)), expected, 1e-5 * expected) << c;
  });
}

// Techniques: 15.7.
TEST(ToneCurves, LogarithmAndWhitePointHaveTheirNumbers) {
  EXPECT_EQ(logarithm(0.0f), 0.0f);
  EXPECT_EQ(logarithm(1.0f), 1.0f);
  EXPECT_EQ(logarithm(1023.0f), 10.0f);
  EXPECT_EQ(inverseLogarithm(10.0f), 1023.0f);
  for (const float white : {0.5f, 1.0f, 4.0f, 64.0f}) {
    EXPECT_EQ(whitePoint(0.0f, white), 0.0f);
    EXPECT_FLOAT_EQ(whitePoint(white, white), 1.0f) << "white is 1";
    EXPECT_FLOAT_EQ(inverseWhitePoint(1.0f, white), white);
    EXPECT_EQ(inverseWhitePoint(0.0f, white), 0.0f);
  }
  // By hand: 3·(1 + 3/16)/4; far beyond white it is c/W².
  EXPECT_EQ(whitePoint(3.0f, 4.0f), 0.890625f);
  EXPECT_NEAR(whitePoint(65504.0f, 4.0f), 65504.0 / 16.0 + 15.0 / 16.0, 1e-3);
  // Without a white it is Reinhard's.
  EXPECT_NEAR(whitePoint(3.0f, 1e6f), 0.75f, 1e-7);
}

TEST(ToneCurves, GoThereAndBackWithinTheirErrorBound) {
  eachLevel([](float c) {
    const auto level = static_cast<double>(c);
    const auto error = [&](float back) { return std::fabs(static_cast<double>(back) / level - 1.0); };
    // In the dark PQ is flat: its fraction less c₁, 0.04 at the least half, is all that is left of 0.88
    // there, and the power 6.3 follows: 22 u of it and 6.3 times that. Half a step of a half float is
    // 49·10⁻⁵.
    ASSERT_LE(error(inversePq(pq(c))), c < 1e-2f ? 1.2e-5 : 2.5e-6) << c;
    // A logarithm of 16 with 7 roundings shows ln 2 of each.
    ASSERT_LE(error(inverseLogarithm(logarithm(c))), 4e-6) << c;
    // Flattest between 1 and W, where c/y·dy/dc is about 2/W: 2 or 3 roundings times W/2.
    for (const float white : {0.5f, 1.0f, 4.0f, 64.0f})
      ASSERT_LE(error(inverseWhitePoint(whitePoint(c, white), white)), 3.0 * 0x1p-24 * (3.0 + 0.6 * white))
          << c << ", W " << white;
  });
}

// IEC 61966-2-1 in double; the tolerance is that of power() with 1/2.4 and 16 at most, and the three
// roundings.
TEST(ToneCurves, GammaIsTheCurveOfSrgbAndBack) {
  EXPECT_EQ(gammaEncoded(0.0f), 0.0f);
  EXPECT_FLOAT_EQ(gammaEncoded(1.0f), 1.0f);
  EXPECT_FLOAT_EQ(gammaEncoded(0.0031308f), 12.92f * 0.0031308f);
  EXPECT_NEAR(gammaEncoded(0.21404114f), 0.5, 3e-7);
  EXPECT_FLOAT_EQ(gammaDecoded(-0.1f), -0.1f / 12.92f) << "a box may reach below black";
  eachLevel([](float c) {
    const auto level = static_cast<double>(c);
    const double coded = level <= 0.0031308 ? 12.92 * level : 1.055 * std::pow(level, 1.0 / 2.4) - 0.055;
    ASSERT_NEAR(static_cast<double>(gammaEncoded(c)), coded, 4e-6 * coded + 1e-8) << c;
    // 2·10⁻⁷ + 3.3·10⁻⁷·|log₂ c| of the way there, 2.4 times, and of the way back.
    const double error = 1e-6 + 7e-7 * std::fabs(std::log2(level));
    ASSERT_NEAR(static_cast<double>(gammaDecoded(gammaEncoded(c))), level, error * level) << c;
  });
}

// Y'CbCr of encoded channels (manual 9.4): of mid gray and of a color computed by hand from the standard.
// Techniques: 9.4.
TEST(ToneCurves, GammaMakesLumaAndChromaOfEncodedColors) {
  const SpaceSettings space{ColorSpace::YCbCr, ToneSpace::Gamma};
  const glm::vec3 gray = toBox(glm::vec3(0.21404114f), space);
  EXPECT_NEAR(gray.x, 0.5f, 1e-6f);
  EXPECT_NEAR(gray.y, 0.0f, 1e-6f);
  EXPECT_NEAR(gray.z, 0.0f, 1e-6f);
  const glm::vec3 color(0.5f, 0.25f, 0.0625f);
  const auto code = [](double c) { return 1.055 * std::pow(c, 1.0 / 2.4) - 0.055; };
  const double r = code(0.5), g = code(0.25), b = code(0.0625), y = 0.2126 * r + 0.7152 * g + 0.0722 * b;
  const glm::vec3 boxed = toBox(color, space);
  EXPECT_NEAR(boxed.x, y, 1e-6);
  EXPECT_NEAR(boxed.y, (b - y) / 1.8556, 1e-6);
  EXPECT_NEAR(boxed.z, (r - y) / 1.5748, 1e-6);
  const glm::vec3 back = fromBox(boxed, space);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(back[k], color[k], 4e-6f * color[k]);
}

TEST(ToneCurves, NeverFallAndNeverGoWild) {
  float last[3] = {-1.0f, -1.0f, -1.0f};
  eachLevel([&](float c) {
    const float now[3] = {pq(c), logarithm(c), whitePoint(c, 4.0f)};
    for (int k = 0; k < 3; ++k) ASSERT_LE(std::exchange(last[k], now[k]), now[k]) << c;
  });
  // Corners of a box in other axes may lie anywhere.
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float y : {-infinity, -1.0f, -1e-30f, 1.99f, 2.0f, 1e30f, infinity, std::nanf("")}) {
    EXPECT_TRUE(std::isfinite(inversePq(y))) << y;
    EXPECT_GE(inversePq(y), 0.0f) << y;
    EXPECT_TRUE(std::isfinite(inverseLogarithm(y))) << y;
  }
}

// Techniques: 9.5.
TEST(ToneCurves, ColorsComeBackThroughTheBoxAndTheMix) {
  for (const ToneSpace tone : {ToneSpace::Pq, ToneSpace::Logarithm})
    for (const float level : {0.0f, 1e-4f, 1.0f, 1000.0f, 65504.0f}) {
      const glm::vec3 back =
          fromBox(toBox(glm::vec3(level), {ColorSpace::YCoCg, tone}), {ColorSpace::YCoCg, tone});
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(back[k], level, 4e-6f * level);
    }
  for (const ToneWeight tone : {ToneWeight::ReinhardChannel, ToneWeight::MaxChannel, ToneWeight::Pq,
                                ToneWeight::Logarithm, ToneWeight::WhitePoint}) {
    EXPECT_TRUE(mixesCompressed(tone));
    BlendSettings settings;
    settings.tone = tone;
    const glm::vec3 color(0.5f, 2.0f, 0.125f), back = decompress(compress(color, settings), settings);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(back[k], color[k], 4e-6f * color[k]);
  }
}

} // namespace
} // namespace taa::twin
