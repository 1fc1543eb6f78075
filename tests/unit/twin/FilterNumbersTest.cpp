// The filters' published numbers (invariants 24, 26 to 28 and 31 to 33): weights of history and current
// filters.
#include "tests/support/frames/TwinInputs.h"

#include "core/taa/twin/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace taa::twin {
namespace {

HistorySettings history(HistoryFilter filter, float sharpness = 0.5f) {
  return {filter, Switch::Off, Precision::Full, sharpness};
}

/// Σ k·w over the four texels at −1, 0, 1, 2.
float centroid(const std::array<float, 4>& w) {
  return -w[0] + w[2] + 2.0f * w[3];
}

TEST(FilterNumbers, ATunableCubicKeepsConstantsWhateverItsSharpness) {
  for (int sharpness = 0; sharpness <= 16; ++sharpness) {
    const HistorySettings cubic = history(HistoryFilter::Cubic, float(sharpness) / 16.0f);
    for (int i = 0; i <= 32; ++i) { // sixteenths and thirty-seconds: every product is exact
      const float f = float(i) / 32.0f;
      const std::array<float, 4> w = cubicWeights(cubic, f), mirrored = cubicWeights(cubic, 1.0f - f);
      ASSERT_EQ(w[0] + w[1] + w[2] + w[3], 1.0f);
      for (std::size_t k = 0; k < 4; ++k) ASSERT_EQ(w[k], mirrored[3 - k]);
      if (sharpness == 8) {
        ASSERT_EQ(w, catmullRomWeights(f));
      }
    }
  }
}

// Techniques: 6.5.
TEST(FilterNumbers, OnlyTheSharpnessOfCatmullRomKeepsRamps) {
  EXPECT_NEAR(centroid(cubicWeights(history(HistoryFilter::Cubic, 0.35f), 0.25f)), 0.22187f, 1e-5f);
  EXPECT_EQ(centroid(cubicWeights(history(HistoryFilter::Cubic, 0.5f), 0.25f)), 0.25f);
}

TEST(FilterNumbers, MitchellKeepsConstantsAndRamps) {
  for (int i = 0; i <= 32; ++i) {
    const float f = float(i) / 32.0f;
    const std::array<float, 4> w = cubicWeights(history(HistoryFilter::Mitchell), f);
    EXPECT_NEAR(w[0] + w[1] + w[2] + w[3], 1.0f, 2e-6f); // roundings of terms up to 20
    EXPECT_NEAR(centroid(w), f, 2e-6f);
  }
}

TEST(FilterNumbers, ThePolynomialOfLanczosIsNearItsSinc) {
  const auto polynomial = [](float x) { // at distance x of 0 to 2
    const std::array<float, 4> w = cubicWeights(history(HistoryFilter::Lanczos), x < 1.0f ? x : x - 1.0f);
    return x < 1.0f ? w[1] : w[0];
  };
  EXPECT_EQ(polynomial(0.0f), 1.0f);
  EXPECT_EQ(polynomial(1.0f), 0.0f);
  EXPECT_EQ(cubicWeights(history(HistoryFilter::Lanczos), 0.0f)[3], 0.0f); // at 2
  double worst = 0.0;
  for (int i = 1; i < 2000; ++i) {
    const double x = i / 1000.0, a = std::numbers::pi * x;
    const double sinc = std::sin(a) / a * std::sin(a / 2.0) / (a / 2.0);
    worst = std::max(worst, std::fabs(double(polynomial(float(x))) - sinc));
  }
  EXPECT_NEAR(worst, 0.0493, 5e-5);
}

// Techniques: 6.3.
TEST(FilterNumbers, NineTapsAreSixteenTexels) {
  Inputs inputs = test::constantInputs(9, 9, glm::vec3(0.0f));
  test::setHistory(inputs, glm::vec3(0.0f), 1.0f);
  std::mt19937 random(27);
  std::uniform_real_distribution<float> level(0.0f, 1.0f), place(0.0f, 9.0f);
  for (int k = 0; k < 81; ++k)
    test::setColor(inputs.historyColor, k % 9, k / 9, {level(random), level(random), level(random)});
  for (int i = 0; i < 2000; ++i) {
    const glm::vec2 q(place(random), place(random));
    const glm::vec3 nine = sampleHistory(inputs, history(HistoryFilter::CatmullRom9), q, {4, 4}).color;
    const glm::vec3 sixteen = sampleHistory(inputs, history(HistoryFilter::CatmullRom16), q, {4, 4}).color;
    for (int k = 0; k < 3; ++k) ASSERT_NEAR(nine[k], sixteen[k], 2e-6f) << q.x << ", " << q.y; // roundings
  }
}

/// What is left of a constant 1 when history is read half a pixel off by five taps that are not normalized.
float gainAsPrinted(float alpha, int frames) {
  Inputs inputs = test::constantInputs(6, 6, glm::vec3(1.0f));
  for (float& component : inputs.motion.pixels) component = 0.5f;
  Settings settings = test::plainSettings();
  settings.history.filter = HistoryFilter::CatmullRom5AsPrinted;
  settings.weight.alpha = alpha;
  float gain = 0.0f;
  for (int frame = 0; frame < frames; ++frame)
    gain = at(test::advance(inputs, settings, 3, 3), IntermediateId::resolved).x;
  return gain;
}

// Techniques: 6.4b, D15.
TEST(FilterNumbers, FiveTapsAsPrintedDarkenAConstant) {
  EXPECT_NEAR(gainAsPrinted(0.1f, 120), 0.8767f, 5e-5f);   // 0.1/(1 − 0.9·63/64)
  EXPECT_NEAR(gainAsPrinted(0.015f, 400), 0.4936f, 5e-5f); // 0.015/(1 − 0.985·63/64)
}

std::array<float, 9> normalized(CurrentFilter filter, const glm::vec2& jitter = glm::vec2(0.0f)) {
  std::array<float, 9> w = currentWeights({filter, 0.22f}, jitter);
  const float sum = std::accumulate(w.begin(), w.end(), 0.0f);
  for (float& weight : w) weight /= sum;
  return w;
}

void expectWeights(CurrentFilter filter, float center, float edge, float corner, float tolerance) {
  const std::array<float, 9> w = normalized(filter);
  EXPECT_NEAR(w[4], center, tolerance);
  for (const std::size_t k : {1u, 3u, 5u, 7u}) EXPECT_NEAR(w[k], edge, tolerance);
  for (const std::size_t k : {0u, 2u, 6u, 8u}) EXPECT_NEAR(w[k], corner, tolerance);
}

// Techniques: 7.5, 7.6.
TEST(FilterNumbers, CurrentFiltersHaveThePublishedWeights) {
  expectWeights(CurrentFilter::Tent, 0.25f, 0.125f, 0.0625f, 0.0f);
  expectWeights(CurrentFilter::Mitchell, 0.9199f, 0.0575f, -0.0375f, 6e-5f);
  expectWeights(CurrentFilter::Gaussian, 0.68748f, 0.07083f, 0.00730f, 6e-6f);
  expectWeights(CurrentFilter::CatmullRom, 1.0f / (1.0f + 4.0f * -0.07107f), 0.0f,
                -0.07107f / (1.0f + 4.0f * -0.07107f), 6e-5f); // 2 − 4r + 2.5r² − 0.5r³ at √2
}

// Techniques: D2, D3.
TEST(FilterNumbers, CurrentFiltersAsPrintedAreNoneAndABoxOfFive) {
  expectWeights(CurrentFilter::DistanceAsPrinted, 0.0f, 1.0f / (4.0f + 4.0f * std::sqrt(2.0f)),
                std::sqrt(2.0f) / (4.0f + 4.0f * std::sqrt(2.0f)), 1e-6f);
  expectWeights(CurrentFilter::MitchellAsPrinted, 1.0f, 0.0f, 0.0f, 1e-7f);
  expectWeights(CurrentFilter::BlackmanHarrisAsPrinted, 0.19888f, 0.19888f, (1.0f - 5.0f * 0.19888f) / 4.0f,
                1e-5f);
}

TEST(FilterNumbers, CurrentFiltersAreSymmetricWithoutJitterAndTurnWithIt) {
  for (const CurrentFilter filter :
       {CurrentFilter::Gaussian, CurrentFilter::Mitchell, CurrentFilter::CatmullRom,
        CurrentFilter::BlackmanHarris, CurrentFilter::Lanczos}) {
    const std::array<float, 9> still = normalized(filter), right = normalized(filter, {0.25f, 0.125f}),
                               left = normalized(filter, {-0.25f, -0.125f});
    for (std::size_t k = 0; k < 9; ++k) {
      EXPECT_EQ(still[k], still[8 - k]);
      EXPECT_NEAR(right[k], left[8 - k], 1e-6f);
    }
    EXPECT_GT(right[5], right[3]) << "the center's content lies towards +x";
  }
}

// Techniques: 7.1.
TEST(FilterNumbers, TheUnjitterTapBringsARampBackExactly) {
  for (const float jitter : {-0.5f, -0.375f, 0.25f, 0.5f}) { // binary fractions: no rounding
    Inputs inputs = test::constantInputs(5, 5, glm::vec3(0.0f));
    inputs.jitterPx = {jitter, -0.5f * jitter};
    for (int k = 0; k < 25; ++k) {
      const glm::vec2 lockState = glm::vec2(float(k % 5), float(k / 5)) - inputs.jitterPx;
      test::setColor(inputs.color, k % 5, k / 5, {16.0f + lockState.x, 16.0f + lockState.y, 0.0f});
    }
    const CurrentSettings unjitter{CurrentFilter::Unjitter, 0.22f};
    EXPECT_EQ(filterCurrent(inputs, unjitter, {2, 2}), glm::vec3(18.0f, 18.0f, 0.0f)) << jitter;
    inputs.jitterPx = -inputs.jitterPx; // the wrong sign doubles the error
    const glm::vec3 wrong = filterCurrent(inputs, unjitter, {2, 2});
    EXPECT_EQ(wrong.x - 18.0f, -2.0f * jitter);
    EXPECT_EQ(wrong.y - 18.0f, jitter);
  }
}

TEST(FilterNumbers, TheLongestOfEqualMotionsIsThePixelsOwn) {
  Inputs inputs = test::constantInputs(5, 5, glm::vec3(0.0f));
  for (int k = 0; k < 25; ++k) {
    inputs.motion.at(k % 5, k / 5)[0] = 3.0f;
    inputs.motion.at(k % 5, k / 5)[1] = -4.0f;
  }
  for (const DilateMethod method : {DilateMethod::Longest3x3, DilateMethod::LongestCross}) {
    const DilatedMotion still = dilateMotion(inputs, {method}, {2, 2});
    EXPECT_EQ(still.offset, glm::ivec2(0));
    EXPECT_EQ(still.motion, glm::vec2(3.0f, -4.0f));
  }
  inputs.motion.at(3, 3)[0] = 3.5f; // the only longer one, on a diagonal
  EXPECT_EQ(dilateMotion(inputs, {DilateMethod::Longest3x3}, {2, 2}).offset, glm::ivec2(1, 1));
  EXPECT_EQ(dilateMotion(inputs, {DilateMethod::LongestCross}, {2, 2}).offset, glm::ivec2(0));
}

} // namespace
} // namespace taa::twin
