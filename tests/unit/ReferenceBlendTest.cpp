// Accumulation of the CPU twin over frames (invariants 44 to 50, 54 to 56).
#include "tests/support/ReferenceInputs.h"

#include "core/taa/reference/Color.h"
#include "core/taa/reference/Stages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace taa::reference {
namespace {

Settings constantAlpha(float alpha) {
  Settings settings = test::plainSettings();
  settings.weight = {AlphaSource::Constant, alpha, 0.0f};
  return settings;
}

Settings byLength(float minimum) {
  Settings settings = test::plainSettings();
  settings.weight = {AlphaSource::HistoryLength, 0.1f, minimum};
  return settings;
}

std::vector<float> randomSamples(std::size_t count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  std::vector<float> samples(count);
  for (float& sample : samples) sample = unit(random);
  return samples;
}

/// f and N after each of the samples, of one pixel at rest.
struct Step {
  double value;
  double length;
};
std::vector<Step> accumulate(const std::vector<float>& samples, const Settings& settings) {
  Inputs inputs = test::constantInputs(1, 1, glm::vec3(0.0f));
  std::vector<Step> steps;
  for (const float sample : samples) {
    test::setColor(inputs.color, 0, 0, glm::vec3(sample));
    const PixelRecord record = test::advance(inputs, settings, 0, 0);
    steps.push_back({at(record, IntermediateId::resolved).x, at(record, IntermediateId::historyLength).x});
  }
  return steps;
}

TEST(ReferenceBlend, ConstantAlphaIsTheUnrolledExponentialAverage) {
  const std::vector<float> s = randomSamples(60);
  for (const float alpha : {0.04f, 0.1f, 0.5f}) {
    const std::vector<Step> steps = accumulate(s, constantAlpha(alpha));
    const double a = alpha;
    for (std::size_t n = 0; n < s.size(); ++n) {
      double expected = std::pow(1.0 - a, n) * s[0];
      for (std::size_t k = 0; k < n; ++k) expected += a * std::pow(1.0 - a, k) * s[n - k];
      EXPECT_NEAR(steps[n].value, expected, 1e-6); // 1/α roundings of 2⁻²⁴ each
    }
  }
}

TEST(ReferenceBlend, EffectiveSamplesFollowTheClosedForm) {
  const std::vector<float> s(500, 0.5f);
  for (const double alpha : {0.04, 0.05, 0.1, 0.125, 0.2}) {
    const std::vector<Step> steps = accumulate(s, constantAlpha(static_cast<float>(alpha)));
    for (const int n : {1, 2, 5, 10, 15, 100, 500}) {
      const double decay = std::pow(1.0 - alpha, 2 * (n - 1));
      const double expected = 1.0 / (alpha * (1.0 - decay) / (2.0 - alpha) + decay);
      EXPECT_NEAR(steps[static_cast<std::size_t>(n - 1)].length, expected, 1e-5 * expected);
    }
    EXPECT_NEAR(steps.back().length, (2.0 - alpha) / alpha, 1e-4);
  }
  // The table of the first source: 5 → 2.17, 10 → 5.13, 15 → 9.78, ∞ → 19.
  const std::vector<Step> steps = accumulate(s, constantAlpha(0.1f));
  EXPECT_NEAR(steps[4].length, 2.17, 0.005);
  EXPECT_NEAR(steps[9].length, 5.13, 0.005);
  EXPECT_NEAR(steps[14].length, 9.78, 0.005);
  EXPECT_NEAR(steps.back().length, 19.0, 1e-4);
}

TEST(ReferenceBlend, GhostsDecayByTheirShareOfHistory) {
  const auto framesToOnePercent = [](float alpha) {
    std::vector<float> s(400, 0.0f);
    s[0] = 1.0f;
    const std::vector<Step> steps = accumulate(s, constantAlpha(alpha));
    std::size_t n = 0;
    while (steps[n].value > 0.01) ++n;
    return n;
  };
  EXPECT_EQ(framesToOnePercent(0.1f), 44u);
  EXPECT_EQ(framesToOnePercent(0.05f), 90u);
  EXPECT_EQ(framesToOnePercent(0.04f), 113u);
  EXPECT_EQ(framesToOnePercent(0.015f), 305u);
}

TEST(ReferenceBlend, PeriodicSamplesSettleToACycleWithTheirMean) {
  const std::size_t period = 8;
  const double alpha = 0.1;
  const std::vector<float> one = randomSamples(period);
  std::vector<float> s;
  for (int repeat = 0; repeat < 30; ++repeat) s.insert(s.end(), one.begin(), one.end());
  const std::vector<Step> steps = accumulate(s, constantAlpha(0.1f));
  double mean = 0.0;
  double cycle = 0.0;
  for (std::size_t phase = 0; phase < period; ++phase) {
    const std::size_t n = s.size() - period + phase;
    double expected = 0.0; // Σ w_k s(φ − k), w_k = α(1−α)^k / (1 − (1−α)^P)
    for (std::size_t k = 0; k < period; ++k) {
      expected += alpha * std::pow(1.0 - alpha, k) / (1.0 - std::pow(1.0 - alpha, period)) *
                  one[(phase + period - k) % period];
    }
    EXPECT_NEAR(steps[n].value, expected, 1e-6);
    mean += one[phase] / static_cast<double>(period);
    cycle += steps[n].value / static_cast<double>(period);
  }
  EXPECT_NEAR(cycle, mean, 1e-6);
}

TEST(ReferenceBlend, AlphaByLengthIsTheArithmeticMean) {
  const std::vector<float> s = randomSamples(256);
  const std::vector<Step> steps = accumulate(s, byLength(0.0f));
  double sum = 0.0;
  for (std::size_t n = 0; n < s.size(); ++n) {
    sum += s[n];
    EXPECT_NEAR(steps[n].value, sum / static_cast<double>(n + 1), std::ldexp(1.0, -20)); // invariant 48
    EXPECT_NEAR(steps[n].length, static_cast<double>(n + 1), 1e-5 * static_cast<double>(n + 1));
  }
}

TEST(ReferenceBlend, TheFloorOfAlphaEndsTheGrowthOfLength) {
  const std::vector<Step> steps = accumulate(std::vector<float>(200, 0.5f), byLength(0.1f));
  // Frame 0 has N = 1; t counts the frames after it (invariant 50).
  const std::array<std::pair<std::size_t, double>, 8> table{
      {{1, 2.0}, {5, 6.0}, {8, 9.0}, {9, 10.0}, {10, 10.99}, {15, 15.15}, {20, 17.45}, {30, 18.80}}};
  for (const auto& [t, length] : table) EXPECT_NEAR(steps[t].length, length, 0.0051) << t;
  EXPECT_NEAR(steps.back().length, 19.0, 1e-4);
  for (std::size_t t = 1; t < steps.size(); ++t) EXPECT_LE(steps[t].length, steps[t - 1].length + 1.0 + 1e-5);
}

TEST(ReferenceBlend, TheFirstFrameIsTheCurrentColorAndDependsOnNothingElse) {
  const Blended first = blend(Settings{}, {0.25f, 0.5f, 2.0f}, glm::vec3(std::nanf("")), 1.0f, std::nanf(""));
  EXPECT_EQ(first.resolved, glm::vec3(0.25f, 0.5f, 2.0f));
  EXPECT_EQ(first.historyLength, 1.0f);
  EXPECT_EQ(first.factor, 1.0f);
}

TEST(ReferenceBlend, ToneWeightsBlendAsReinhardSpaceDoes) {
  Settings settings = constantAlpha(0.1f);
  settings.blend.tone = ToneWeight::Luma;
  const SpaceSettings reinhard{ColorSpace::Rgb, ToneSpace::ReinhardLuma};
  std::mt19937 random(9);
  std::uniform_real_distribution<float> level(0.0f, 8.0f);
  for (int i = 0; i < 200; ++i) {
    const glm::vec3 s(level(random), level(random), level(random));
    const glm::vec3 h(level(random), level(random), level(random));
    const glm::vec3 t = toBox(h, reinhard) + 0.1f * (toBox(s, reinhard) - toBox(h, reinhard));
    const glm::vec3 expected = fromBox(t, reinhard);
    const Blended blended = blend(settings, s, h, 0.1f, 9.0f);
    const glm::vec3 plain = h + 0.1f * (s - h);
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(blended.resolved[k], expected[k], 1e-5f * (1.0f + luma(s) + luma(h))); // invariant 55
      EXPECT_GE(blended.resolved[k], std::min(s[k], h[k]) - 1e-6f);
      EXPECT_LE(blended.resolved[k], std::max(s[k], h[k]) + 1e-6f);
    }
    EXPECT_LE(luma(blended.resolved), luma(plain) + 1e-5f);
  }
}

TEST(ReferenceBlend, ToneWeightsTameFireflies) {
  Settings settings = constantAlpha(0.1f);
  settings.blend.tone = ToneWeight::Luma;
  const auto gray = [&settings](float s) {
    return blend(settings, glm::vec3(s), glm::vec3(0.0f), 0.1f, 9.0f).resolved.x;
  };
  EXPECT_NEAR(gray(100.0f), 0.10989f, 5e-6f); // invariant 56, instead of 10
  EXPECT_NEAR(gray(65504.0f), 0.11111f, 5e-6f);
  settings.blend.tone = ToneWeight::None;
  EXPECT_FLOAT_EQ(gray(100.0f), 10.0f);
}

TEST(ReferenceBlend, RoundsStoredHistoryToTheNearestHalf) {
  Settings settings = constantAlpha(0.5f);
  settings.history.precision = Precision::Half;
  // ½(1 + (1 + 2⁻¹⁰)) lies between two halves: to even. With full precision it stays.
  const glm::vec3 s(1.0009765625f);
  EXPECT_EQ(blend(settings, s, glm::vec3(1.0f), 0.5f, 1.0f).resolved, glm::vec3(1.0f));
  EXPECT_EQ(blend(settings, s, glm::vec3(1.001953125f), 0.5f, 1.0f).resolved, glm::vec3(1.001953125f));
  settings.history.precision = Precision::Full;
  EXPECT_EQ(blend(settings, s, glm::vec3(1.0f), 0.5f, 1.0f).resolved, glm::vec3(1.00048828125f));
}

} // namespace
} // namespace taa::reference
