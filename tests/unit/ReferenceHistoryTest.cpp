// History filters of the CPU twin (invariants 26, 28 to 30).
#include "tests/support/ReferenceInputs.h"

#include "core/taa/reference/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace taa::reference {
namespace {

constexpr HistorySettings kBilinear{HistoryFilter::Bilinear, Switch::Off, Precision::Full};
constexpr HistorySettings kCatmullRom{HistoryFilter::CatmullRom5, Switch::Off, Precision::Full};
constexpr HistorySettings kDeringed{HistoryFilter::CatmullRom5, Switch::On, Precision::Full};

Inputs withHistory(int width, int height, const glm::vec3& color) {
  Inputs inputs = test::constantInputs(width, height, glm::vec3(0.0f));
  test::setHistory(inputs, color, 4.0f);
  return inputs;
}

TEST(ReferenceHistory, CubicWeightsAreCatmullRoms) {
  EXPECT_EQ(catmullRomWeights(0.0f), (std::array<float, 4>{0.0f, 1.0f, 0.0f, 0.0f}));
  EXPECT_EQ(catmullRomWeights(0.5f), (std::array<float, 4>{-0.0625f, 0.5625f, 0.5625f, -0.0625f}));
  for (int i = 0; i <= 64; ++i) { // multiples of 1/64: every product is exact
    const float f = static_cast<float>(i) / 64.0f;
    const std::array<float, 4> w = catmullRomWeights(f);
    const std::array<float, 4> mirrored = catmullRomWeights(1.0f - f);
    EXPECT_EQ(w[0] + w[1] + w[2] + w[3], 1.0f);
    EXPECT_EQ(-w[0] + w[2] + 2.0f * w[3], f);
    EXPECT_EQ(w[0] + w[2] + 4.0f * w[3], f * f);
    EXPECT_GE(w[1] + w[2], 1.0f);
    EXPECT_LE(w[1] + w[2], 1.125f);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(w[k], mirrored[3 - k]);
  }
}

TEST(ReferenceHistory, BilinearMixesTheFourTexelsAround) {
  Inputs inputs = withHistory(2, 2, glm::vec3(0.0f));
  test::setColor(inputs.historyColor, 1, 0, glm::vec3(4.0f));
  test::setColor(inputs.historyColor, 0, 1, glm::vec3(8.0f));
  test::setColor(inputs.historyColor, 1, 1, glm::vec3(16.0f));
  EXPECT_EQ(bilinearHistory(inputs, {0.5f, 0.5f}).x, 0.0f);
  EXPECT_EQ(bilinearHistory(inputs, {1.0f, 0.5f}).x, 2.0f);
  EXPECT_EQ(bilinearHistory(inputs, {1.0f, 1.0f}).x, 7.0f);
  EXPECT_EQ(bilinearHistory(inputs, {0.75f, 1.25f}).x, 7.75f); // ¼ of 1, ¾ of 10
  EXPECT_EQ(bilinearHistory(inputs, {-5.0f, 9.0f}).x, 8.0f);   // clamped to the edge
}

TEST(ReferenceHistory, BothFiltersReadATexelExactlyAtItsCenter) {
  Inputs inputs = withHistory(7, 7, glm::vec3(0.25f));
  test::setColor(inputs.historyColor, 3, 3, {1.0f, 2.0f, 3.0f});
  for (const HistorySettings& settings : {kBilinear, kCatmullRom, kDeringed}) {
    const HistorySample sample = sampleHistory(inputs, settings, {3.5f, 3.5f}, {3, 3});
    EXPECT_EQ(sample.color, glm::vec3(1.0f, 2.0f, 3.0f));
    EXPECT_EQ(sample.length, 4.0f);
  }
}

TEST(ReferenceHistory, NormalizedFiveTapsKeepConstantsExactlyAndRampsClosely) {
  Inputs constant = withHistory(8, 8, glm::vec3(0.7f));
  Inputs ramp = withHistory(8, 8, glm::vec3(0.0f));
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      test::setColor(ramp.historyColor, x, y,
                     {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, 0.0f});
    }
  }
  float worst = 0.0f;
  for (int i = 0; i < 100; ++i) {
    for (int j = 0; j < 100; ++j) {
      const glm::vec2 q(3.5f + static_cast<float>(i) / 100.0f, 3.5f + static_cast<float>(j) / 100.0f);
      ASSERT_EQ(sampleHistory(constant, kCatmullRom, q, {3, 3}).color, glm::vec3(0.7f));
      const glm::vec3 color = sampleHistory(ramp, kCatmullRom, q, {3, 3}).color;
      worst = std::max({worst, std::fabs(color.x - q.x), std::fabs(color.y - q.y)});
    }
  }
  EXPECT_NEAR(worst, 0.00608f, 1e-5f); // invariant 28, to the digits it gives
}

TEST(ReferenceHistory, OvershootsOnAStepUnlessDeringedAndNeverGoesBelowZero) {
  Inputs inputs = withHistory(8, 8, glm::vec3(0.0f));
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 4; ++x) test::setColor(inputs.historyColor, x, y, glm::vec3(1.0f));
  }
  float highest = 0.0f;
  float lowest = 1.0f;
  for (int i = 0; i <= 3000; ++i) {
    const glm::vec2 q(1.5f + static_cast<float>(i) / 1000.0f, 3.5f); // rows are equal: one-dimensional
    const float plain = sampleHistory(inputs, kCatmullRom, q, {3, 3}).color.x;
    const float deringed = sampleHistory(inputs, kDeringed, q, {3, 3}).color.x;
    highest = std::max(highest, plain);
    lowest = std::min(lowest, plain);
    EXPECT_LE(deringed, 1.0f);
    EXPECT_GE(deringed, 0.0f);
  }
  EXPECT_NEAR(highest, 1.0741f, 1e-4f); // 1 + 2/27
  EXPECT_EQ(lowest, 0.0f);              // the undershoot of −2/27 is cut off
}

/// Spread, px², of a one-pixel bump of history after `frames` steps of half a pixel, nothing blended in.
double varianceAfter(int frames, HistoryFilter filter) {
  constexpr int kWidth = 64;       // a power of two: all arithmetic below is exact
  constexpr float kGround = 16.0f; // keeps negative lobes positive
  Inputs inputs = test::constantInputs(kWidth, 1, glm::vec3(kGround));
  for (int x = 0; x < kWidth; ++x) inputs.motion.at(x, 0)[0] = 0.5f;
  test::setHistory(inputs, glm::vec3(kGround), 1.0f);
  test::setColor(inputs.historyColor, 20, 0, glm::vec3(kGround + 1.0f));
  Settings settings = test::plainSettings();
  settings.history.filter = filter;
  settings.weight.alpha = 0.0f;
  for (int frame = 0; frame < frames; ++frame) test::advance(inputs, settings, 0, 0);
  double mass = 0.0;
  double mean = 0.0;
  double square = 0.0;
  for (int x = 0; x < kWidth; ++x) {
    const double bump = inputs.historyColor.at(x, 0)[0] - kGround;
    mass += bump;
    mean += bump * x;
    square += bump * x * x;
  }
  EXPECT_EQ(mass, 1.0);
  EXPECT_EQ(mean, 20.0 + 0.5 * frames);
  return square - mean * mean;
}

TEST(ReferenceHistory, BilinearAddsAQuarterSquarePixelPerHalfPixelStepAndCatmullRomNothing) {
  for (int frames = 1; frames <= 4; ++frames) {
    EXPECT_EQ(varianceAfter(frames, HistoryFilter::Bilinear), 0.25 * frames); // f(1 − f), invariant 30
    EXPECT_EQ(varianceAfter(frames, HistoryFilter::CatmullRom5), 0.0);
  }
}

TEST(ReferenceHistory, StoredGarbageBecomesBlackAndFarPositionsReadThePixelItself) {
  Inputs inputs = withHistory(4, 4, glm::vec3(0.5f));
  for (const float bad : {std::nanf(""), INFINITY, -INFINITY, -1.0f}) {
    for (int x = 0; x < 4; ++x) test::setColor(inputs.historyColor, x, 1, glm::vec3(bad));
    EXPECT_EQ(sampleHistory(inputs, kBilinear, {1.5f, 1.5f}, {1, 1}).color, glm::vec3(0.0f)) << bad;
    EXPECT_EQ(sampleHistory(inputs, kCatmullRom, {1.5f, 1.5f}, {1, 1}).color, glm::vec3(0.0f)) << bad;
  }
  EXPECT_EQ(sampleHistory(inputs, kBilinear, {2e6f, 0.5f}, {2, 3}).position, glm::vec2(2.5f, 3.5f));
  EXPECT_EQ(sampleHistory(inputs, kBilinear, {std::nanf(""), 0.5f}, {2, 3}).position, glm::vec2(2.5f, 3.5f));
}

TEST(ReferenceHistory, IsBlackAndEmptyWithoutHistory) {
  const Inputs inputs = test::constantInputs(4, 4, glm::vec3(1.0f));
  const HistorySample sample = sampleHistory(inputs, kDeringed, {1.5f, 1.5f}, {1, 1});
  EXPECT_EQ(sample.color, glm::vec3(0.0f));
  EXPECT_EQ(sample.length, 0.0f);
}

} // namespace
} // namespace taa::reference
