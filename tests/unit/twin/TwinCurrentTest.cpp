// The current filter of the CPU twin (invariants 31, 33).
#include "tests/support/frames/TwinInputs.h"

#include "core/taa/twin/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace taa::twin {
namespace {

constexpr CurrentSettings kGaussian{CurrentFilter::Gaussian, 0.22f};

// Techniques: 7.4.
TEST(TwinCurrent, GaussianAtRestHasTheWeightsOfBlackmanHarris) {
  const std::array<float, 9> w = gaussianWeights(0.22f, glm::vec2(0.0f));
  const float sum = std::accumulate(w.begin(), w.end(), 0.0f);
  EXPECT_NEAR(w[4] / sum, 0.68748f, 5e-6f); // invariant 31, to the digits it gives
  for (const std::size_t edge : {1u, 3u, 5u, 7u}) EXPECT_NEAR(w[edge] / sum, 0.07083f, 5e-6f);
  for (const std::size_t corner : {0u, 2u, 6u, 8u}) EXPECT_NEAR(w[corner] / sum, 0.00730f, 5e-6f);
  EXPECT_EQ(w[4], 1.0f);
}

TEST(TwinCurrent, WeighsMostTheSampleThatLandedNearest) {
  // Content moved by +0.4 px to the right: what belongs to the center of pixel p now lies towards p + 1.
  const std::array<float, 9> w = gaussianWeights(0.22f, {0.4f, 0.0f});
  EXPECT_GT(w[5], w[3]);
  EXPECT_EQ(w[5],
            static_cast<float>(std::exp(-std::pow(1.0 - static_cast<double>(0.4f), 2) / (2.0 * 0.22f))));
  const std::array<float, 9> mirrored = gaussianWeights(0.22f, {-0.4f, 0.0f});
  for (std::size_t k = 0; k < 9; ++k) EXPECT_EQ(w[k], mirrored[8 - k]);
}

TEST(TwinCurrent, KeepsConstantsExactlyWhateverTheJitter) {
  Inputs inputs = test::constantInputs(4, 4, {0.3f, 1e-4f, 1000.0f});
  for (int i = 0; i < 16; ++i) {
    inputs.jitterPx = {static_cast<float>(i) / 16.0f - 0.5f, 0.5f - static_cast<float>(i) / 16.0f};
    EXPECT_EQ(filterCurrent(inputs, kGaussian, {i % 4, i / 4}), glm::vec3(0.3f, 1e-4f, 1000.0f));
  }
}

// Techniques: 7.0.
TEST(TwinCurrent, SpreadsAnImpulseByItsWeights) {
  Inputs inputs = test::constantInputs(5, 5, glm::vec3(0.0f));
  test::setColor(inputs.color, 2, 2, glm::vec3(1.0f));
  EXPECT_EQ(filterCurrent(inputs, {CurrentFilter::Center, 0.22f}, {2, 2}), glm::vec3(1.0f));
  EXPECT_EQ(filterCurrent(inputs, {CurrentFilter::Center, 0.22f}, {1, 2}), glm::vec3(0.0f));
  EXPECT_NEAR(filterCurrent(inputs, kGaussian, {2, 2}).x, 0.68748f, 5e-6f);
  EXPECT_NEAR(filterCurrent(inputs, kGaussian, {1, 2}).x, 0.07083f, 5e-6f);
  EXPECT_NEAR(filterCurrent(inputs, kGaussian, {1, 1}).x, 0.00730f, 5e-6f);
}

TEST(TwinCurrent, MovesAJitteredRampBackToTheCenter) {
  // Pixel p holds the ramp at p − j. A perfect filter returns the ramp at p; the wrong sign of j would
  // double the error instead (invariant 33).
  for (const float jitter : {-0.5f, -0.25f, 0.25f, 0.5f}) {
    Inputs inputs = test::constantInputs(5, 1, glm::vec3(0.0f));
    inputs.jitterPx.x = jitter;
    for (int x = 0; x < 5; ++x)
      test::setColor(inputs.color, x, 0, glm::vec3(10.0f + static_cast<float>(x) - jitter));
    const float error = filterCurrent(inputs, kGaussian, {2, 0}).x - 12.0f;
    EXPECT_LT(std::fabs(error), 0.7f * std::fabs(jitter)) << jitter;
    inputs.jitterPx.x = -jitter;
    EXPECT_GT(std::fabs(filterCurrent(inputs, kGaussian, {2, 0}).x - 12.0f), std::fabs(jitter));
  }
}

// Invariant 33: a tap at p + j gives the ramp at rest, one at p − j, as source 002's text has it (manual §26,
// D10), is off by 2 j.
// Techniques: D10.
TEST(TwinCurrent, UnjitteringAsPrintedDoublesTheJitter) {
  for (const float jitter : {-0.5f, -0.25f, 0.25f, 0.5f}) {
    Inputs inputs = test::constantInputs(5, 1, glm::vec3(0.0f));
    inputs.jitterPx.x = jitter;
    for (int x = 0; x < 5; ++x)
      test::setColor(inputs.color, x, 0, glm::vec3(10.0f + static_cast<float>(x) - jitter));
    EXPECT_EQ(filterCurrent(inputs, {.filter = CurrentFilter::Unjitter}, {2, 0}).x, 12.0f);
    EXPECT_EQ(filterCurrent(inputs, {.filter = CurrentFilter::UnjitterAsPrinted}, {2, 0}).x,
              12.0f - 2.0f * jitter);
  }
}

TEST(TwinCurrent, TakesBadChannelsForBlack) {
  Inputs inputs = test::constantInputs(1, 1, {std::nanf(""), -1.0f, 65505.0f});
  EXPECT_EQ(filterCurrent(inputs, {CurrentFilter::Center, 0.22f}, {0, 0}), glm::vec3(0.0f));
  EXPECT_EQ(filterCurrent(inputs, kGaussian, {0, 0}), glm::vec3(0.0f));
}

// Invariant 62: as printed what is flat becomes s times as bright.
// Techniques: 18.2, D10.
TEST(TwinCurrent, SharpeningKeepsConstantsButAsPrintedScalesThem) {
  const Inputs inputs = test::constantInputs(4, 4, {0.25f, 1e-4f, 1000.0f});
  for (const float amount : {0.0f, 0.5f, 1.0f, 4.0f}) {
    CurrentSettings settings{CurrentFilter::Center, 0.22f};
    settings.sharpenAmount = amount;
    settings.sharpen = CurrentSharpen::Laplacian;
    EXPECT_EQ(filterCurrent(inputs, settings, {1, 1}), glm::vec3(0.25f, 1e-4f, 1000.0f));
    settings.sharpen = CurrentSharpen::LaplacianAsPrinted;
    EXPECT_FLOAT_EQ(filterCurrent(inputs, settings, {1, 1}).x, amount * 0.25f);
    EXPECT_FLOAT_EQ(filterCurrent(inputs, settings, {1, 1}).z, amount * 1000.0f);
  }
}

// Techniques: 18.2.
TEST(TwinCurrent, SharpeningAddsTheDifferenceToTheFourAround) {
  Inputs inputs = test::constantInputs(3, 3, glm::vec3(1.0f));
  test::setColor(inputs.color, 1, 1, glm::vec3(2.0f));
  test::setColor(inputs.color, 0, 0, glm::vec3(9.0f)); // a corner does not count
  CurrentSettings settings{CurrentFilter::Center, 0.22f};
  settings.sharpen = CurrentSharpen::Laplacian;
  settings.sharpenAmount = 0.5f;
  EXPECT_EQ(filterCurrent(inputs, settings, {1, 1}), glm::vec3(2.5f));
  settings.sharpen = CurrentSharpen::LaplacianAsPrinted;
  settings.sharpenAmount = 1.0f;
  EXPECT_EQ(filterCurrent(inputs, settings, {1, 1}), glm::vec3(6.0f)); // 5 · 2 − 4
  settings.sharpen = CurrentSharpen::Laplacian;
  settings.sharpenAmount = 4.0f;
  EXPECT_EQ(filterCurrent(inputs, settings, {1, 1}), glm::vec3(6.0f)) << "4 of the corrected one";
}

} // namespace
} // namespace taa::twin
