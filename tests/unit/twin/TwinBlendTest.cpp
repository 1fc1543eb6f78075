// Accumulation of the CPU twin over frames (invariants 44 to 50, 54 to 56).
#include "tests/support/frames/TwinInputs.h"

#include "core/taa/twin/Color.h"
#include "core/taa/twin/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace taa::twin {
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

// Blue of 3 has the luma 0.2166 by Rec. 709 and 0.75 as the Y of YCoCg: it weighs 0.822 or 0.571.
// Techniques: 15.1.
TEST(TwinBlend, WeighsByTheLumaThatIsChosen) {
  Settings settings;
  settings.blend.tone = ToneWeight::Luma;
  BlendInputs mix;
  mix.current = glm::vec3(0.0f, 0.0f, 3.0f);
  mix.history = glm::vec3(1.0f);
  mix.alpha = 0.5f;
  mix.historyLength = 4.0f;
  Blended byRec709 = blend(settings, mix);
  EXPECT_FLOAT_EQ(byRec709.toneWeightCurrent, 1.0f / 1.2166f);
  EXPECT_FLOAT_EQ(byRec709.toneWeightHistory, 0.5f);
  settings.space.luma = WeightLuma::YCoCg;
  const Blended byY = blend(settings, mix);
  EXPECT_FLOAT_EQ(byY.toneWeightCurrent, 1.0f / 1.75f);
  EXPECT_FLOAT_EQ(byY.toneWeightHistory, 0.5f) << "gray has the same luma either way";
  EXPECT_FLOAT_EQ(byY.factor, (1.0f / 1.75f) / (1.0f / 1.75f + 0.5f));
  settings.blend.tone = ToneWeight::LumaAsPrinted; // of 3/(1 + 3)
  EXPECT_FLOAT_EQ(blend(settings, mix).toneWeightCurrent, 1.0f / 1.1875f);
}

// Techniques: 13.1.
TEST(TwinBlend, ConstantAlphaIsTheUnrolledExponentialAverage) {
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

// Techniques: 16.
TEST(TwinBlend, EffectiveSamplesFollowTheClosedForm) {
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

TEST(TwinBlend, GhostsDecayByTheirShareOfHistory) {
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

TEST(TwinBlend, PeriodicSamplesSettleToACycleWithTheirMean) {
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

// Techniques: 13.2.
TEST(TwinBlend, AlphaByLengthIsTheArithmeticMean) {
  const std::vector<float> s = randomSamples(256);
  const std::vector<Step> steps = accumulate(s, byLength(0.0f));
  double sum = 0.0;
  for (std::size_t n = 0; n < s.size(); ++n) {
    sum += s[n];
    EXPECT_NEAR(steps[n].value, sum / static_cast<double>(n + 1), std::ldexp(1.0, -20)); // invariant 48
    EXPECT_NEAR(steps[n].length, static_cast<double>(n + 1), 1e-5 * static_cast<double>(n + 1));
  }
}

// Techniques: 13.3.
TEST(TwinBlend, TheFloorOfAlphaEndsTheGrowthOfLength) {
  const std::vector<Step> steps = accumulate(std::vector<float>(200, 0.5f), byLength(0.1f));
  // Frame 0 has N = 1; t counts the frames after it (invariant 50).
  const std::array<std::pair<std::size_t, double>, 8> table{
      {{1, 2.0}, {5, 6.0}, {8, 9.0}, {9, 10.0}, {10, 10.99}, {15, 15.15}, {20, 17.45}, {30, 18.80}}};
  for (const auto& [t, length] : table) EXPECT_NEAR(steps[t].length, length, 0.0051) << t;
  EXPECT_NEAR(steps.back().length, 19.0, 1e-4);
  for (std::size_t t = 1; t < steps.size(); ++t) EXPECT_LE(steps[t].length, steps[t - 1].length + 1.0 + 1e-5);
}

TEST(TwinBlend, TheFirstFrameIsTheCurrentColorAndDependsOnNothingElse) {
  const Blended first = blend(
      Settings{},
      {.current = {0.25f, 0.5f, 2.0f}, .history = glm::vec3(std::nanf("")), .historyLength = std::nanf("")});
  EXPECT_EQ(first.resolved, glm::vec3(0.25f, 0.5f, 2.0f));
  EXPECT_EQ(first.historyLength, 1.0f);
  EXPECT_EQ(first.factor, 1.0f);
}

// Techniques: 1.3, 15.2.
TEST(TwinBlend, ToneWeightsBlendAsReinhardSpaceDoes) {
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
    const Blended blended =
        blend(settings, {.current = s, .history = h, .alpha = 0.1f, .historyLength = 9.0f});
    const glm::vec3 plain = h + 0.1f * (s - h);
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(blended.resolved[k], expected[k], 1e-5f * (1.0f + luma(s) + luma(h))); // invariant 55
      EXPECT_GE(blended.resolved[k], std::min(s[k], h[k]) - 1e-6f);
      EXPECT_LE(blended.resolved[k], std::max(s[k], h[k]) + 1e-6f);
    }
    EXPECT_LE(luma(blended.resolved), luma(plain) + 1e-5f);
  }
}

// Techniques: 15.1.
TEST(TwinBlend, ToneWeightsTameFireflies) {
  Settings settings = constantAlpha(0.1f);
  settings.blend.tone = ToneWeight::Luma;
  const auto gray = [&settings](float s) {
    return blend(settings, {.current = glm::vec3(s), .alpha = 0.1f, .historyLength = 9.0f}).resolved.x;
  };
  EXPECT_NEAR(gray(100.0f), 0.10989f, 5e-6f); // invariant 56, instead of 10
  EXPECT_NEAR(gray(65504.0f), 0.11111f, 5e-6f);
  settings.blend.tone = ToneWeight::None;
  EXPECT_FLOAT_EQ(gray(100.0f), 10.0f);
}

// Manual 15.5 to 15.7: the mean of what the curve makes of both.
// Techniques: 15.5, 15.6, 15.7.
TEST(TwinBlend, CurvesMixAsTheyCompress) {
  Settings settings = constantAlpha(0.1f);
  const auto gray = [&settings](ToneWeight tone, float current, float history) {
    settings.blend.tone = tone;
    const BlendInputs mix{
        .current = glm::vec3(current), .history = glm::vec3(history), .alpha = 0.1f, .historyLength = 9.0f};
    return static_cast<double>(blend(settings, mix).resolved.x);
  };
  // log₂ of 1 + c: from 1 to 15 by a tenth of 3 octaves.
  EXPECT_NEAR(gray(ToneWeight::Logarithm, 15.0f, 1.0f), std::exp2(1.3) - 1.0, 1e-6);
  // Of white 4: 0.1 of T(4) = 1 is y = 0.1, and c²/16 + 0.9c − 0.1 = 0.
  settings.blend.white = 4.0f;
  EXPECT_NEAR(gray(ToneWeight::WhitePoint, 4.0f, 0.0f), 8.0 * (std::sqrt(0.81 + 0.1 / 4.0) - 0.9), 1e-7);
  // 0.9·0.508078 + 0.1 of PQ is 0.557271, code of 162.05 cd/m².
  EXPECT_NEAR(gray(ToneWeight::Pq, 10000.0f, 100.0f), 162.0502, 1e-3);
  for (const ToneWeight tone : {ToneWeight::Pq, ToneWeight::Logarithm, ToneWeight::WhitePoint}) {
    EXPECT_LT(gray(tone, 100.0f, 1.0f), gray(ToneWeight::None, 100.0f, 1.0f)) << "highlights count less";
    for (const float level : {0.0f, 1e-4f, 1.0f, 1000.0f, 65504.0f})
      EXPECT_EQ(gray(tone, level, level), static_cast<double>(level)); // invariant 60
    EXPECT_EQ(gray(tone, 0.0f, 0.0f), 0.0);
    EXPECT_NEAR(gray(tone, 65504.0f, 65503.0f), 65503.1, 0.5);
  }
}

// Techniques: 1.6.
TEST(TwinBlend, RoundsStoredHistoryToTheNearestHalf) {
  Settings settings = constantAlpha(0.5f);
  settings.history.precision = Precision::Half;
  // ½(1 + (1 + 2⁻¹⁰)) lies between two halves: to even. With full precision it stays.
  const glm::vec3 s(1.0009765625f);
  EXPECT_EQ(blend(settings, {.current = s, .history = glm::vec3(1.0f), .alpha = 0.5f, .historyLength = 1.0f})
                .resolved,
            glm::vec3(1.0f));
  EXPECT_EQ(blend(settings,
                  {.current = s, .history = glm::vec3(1.001953125f), .alpha = 0.5f, .historyLength = 1.0f})
                .resolved,
            glm::vec3(1.001953125f));
  settings.history.precision = Precision::Full;
  EXPECT_EQ(blend(settings, {.current = s, .history = glm::vec3(1.0f), .alpha = 0.5f, .historyLength = 1.0f})
                .resolved,
            glm::vec3(1.00048828125f));
}

/// Bits of the history, of a value that is held by α against black.
Settings storedAs(Precision precision, Switch dither, float alpha = 0.1f) {
  Settings settings = constantAlpha(alpha);
  settings.history.precision = precision;
  settings.history.dither = dither;
  return settings;
}

// Invariant 52: without dither the average stops ½ step over α before its goal.
// Techniques: 14.7, 20.6.
TEST(TwinBlend, EightBitsStallAndDitherTakesTheBiasAway) {
  const float goal = 200.0f / 255.0f;
  const auto stalledAt = [goal](float alpha) {
    std::vector<float> s(600, goal);
    s[0] = 0.0f;
    return accumulate(s, storedAs(Precision::Unorm8, Switch::Off, alpha)).back().value * 255.0;
  };
  EXPECT_NEAR(stalledAt(0.1f), 196.0, 1e-4);
  EXPECT_NEAR(stalledAt(0.04f), 188.0, 1e-4);

  for (const float alpha : {0.1f, 0.04f}) {
    const Settings settings = storedAs(Precision::Unorm8, Switch::On, alpha);
    double sum = 0.0;
    BlendInputs mix{.current = glm::vec3(goal), .alpha = alpha};
    for (int pixel = 0; pixel < 64; ++pixel) {
      mix.pixel = {pixel % 8, pixel / 8};
      mix.history = glm::vec3(0.0f);
      for (mix.frame = 1; mix.frame <= 600; ++mix.frame) {
        mix.history = blend(settings, mix).resolved;
        if (mix.frame > 200) sum += static_cast<double>((mix.history.x + mix.history.y) + mix.history.z);
      }
    }
    // The rounding's variance, at most ¼, becomes 1/(2α) of it; 64·3 chains of some 400·α independent values.
    EXPECT_NEAR(sum / (64.0 * 3.0 * 400.0) * 255.0, 200.0, 0.15) << alpha;
  }
}

// Techniques: 1.6.
TEST(TwinBlend, DitherKeepsWhatCanBeStoredAndRoundsTheRestToEitherSide) {
  BlendInputs mix{.alpha = 1.0f};
  for (const auto& [precision, steps] :
       {std::pair(Precision::Unorm8, 255), std::pair(Precision::Unorm10, 1023)}) {
    const Settings settings = storedAs(precision, Switch::On);
    for (int k = 0; k <= steps; ++k) {
      mix.current = glm::vec3(static_cast<float>(k) / static_cast<float>(steps));
      for (mix.frame = 0; mix.frame < 50; ++mix.frame)
        ASSERT_EQ(blend(settings, mix).resolved, mix.current) << k;
    }
  }
  const Settings half = storedAs(Precision::Half, Switch::On);
  for (const float value : {0.0f, 0x1p-24f, 0x1.4p-15f, 0x1p-14f, 0.3330078125f, 1.0f, 65504.0f}) {
    mix.current = glm::vec3(value);
    for (mix.frame = 0; mix.frame < 200; ++mix.frame)
      ASSERT_EQ(blend(half, mix).resolved, mix.current) << value;
  }
  for (const float low : {0x1.8p-16f, 0x1p-10f, 1.0f, 1000.0f}) { // a quarter of the way to the next half
    const float step = low < 0x1p-14f ? 0x1p-24f : std::ldexp(1.0f, std::ilogb(low) - 10);
    int above = 0;
    mix.current = glm::vec3(low + 0.25f * step);
    for (mix.frame = 0; mix.frame < 4000; ++mix.frame) {
      const glm::vec3 stored = blend(half, mix).resolved;
      for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(stored[i] == low || stored[i] == low + step) << stored[i];
        above += stored[i] != low;
      }
    }
    EXPECT_NEAR(above / 12000.0, 0.25, 4.0 * std::sqrt(0.1875 / 12000.0)) << low; // four deviations
  }
}

// Manual 20.6: the noise must not go with the jitter's period.
TEST(TwinBlend, DitherIsWhiteOverFramesPixelsAndChannels) {
  const Settings settings = storedAs(Precision::Unorm8, Switch::On);
  BlendInputs mix{.current = glm::vec3(0.5f / 255.0f), .alpha = 1.0f}; // 0 or 1/255, even odds
  const auto sign = [&](int frame, int x, int y, int channel) {
    mix.frame = frame;
    mix.pixel = {x, y};
    return blend(settings, mix).resolved[channel] > 0.0f ? 1.0 : -1.0;
  };
  const int n = 4000;
  const double limit = 4.0 * std::sqrt(n); // four deviations of a sum of n signs
  for (const int lag : {1, 2, 4, 8, 16, 32}) {
    double overFrames = 0.0, overColumns = 0.0, overRows = 0.0;
    for (int i = 0; i < n; ++i) {
      overFrames += sign(i, 5, 7, 0) * sign(i + lag, 5, 7, 0);
      overColumns += sign(3, i, 7, 1) * sign(3, i + lag, 7, 1);
      overRows += sign(3, 5, i, 2) * sign(3, 5, i + lag, 2);
    }
    EXPECT_LT(std::abs(overFrames), limit) << lag;
    EXPECT_LT(std::abs(overColumns), limit) << lag;
    EXPECT_LT(std::abs(overRows), limit) << lag;
  }
  double acrossChannels = 0.0;
  for (int i = 0; i < n; ++i) acrossChannels += sign(i, 1, 2, 0) * sign(i, 1, 2, 1);
  EXPECT_LT(std::abs(acrossChannels), limit);
}

// Manual 14.2: (w_s s + w_h h)/(w_s + w_h) of each channel by itself.
// Techniques: 14.2.
TEST(TwinBlend, ChannelsAreMixedByTheirOwnWeights) {
  Settings settings = test::plainSettings();
  settings.weight.source = AlphaSource::ContrastPerChannel;
  const glm::vec3 s{0.25f, 0.5f, 8.0f}, h{1.0f, 0.125f, 2.0f}, weights{0.25f, 0.75f, 1.0f};
  const BlendInputs mix{
      .current = s, .history = h, .alpha = 0.5f, .channels = weights, .historyLength = 3.0f};
  EXPECT_EQ(blend(settings, mix).resolved, h + weights * (s - h)) << "all products are exact";
  settings.blend.tone = ToneWeight::Luma;
  const glm::vec3 resolved = blend(settings, mix).resolved;
  const double ws = 1.0 / (1.0 + luma(s)), wh = 1.0 / (1.0 + luma(h));
  for (int i = 0; i < 3; ++i) {
    const double current = weights[i] * ws, history = (1.0 - weights[i]) * wh;
    EXPECT_NEAR(resolved[i], (current * s[i] + history * h[i]) / (current + history), 1e-6);
  }
  settings.weight.source = AlphaSource::Contrast;
  settings.blend.tone = ToneWeight::None;
  EXPECT_EQ(blend(settings, mix).resolved, h + 0.5f * (s - h)) << "one weight for all";
}

// Invariant 51: w' = 1/(2 − w) from w = ½ gives k/(k + 1), whose α is that of the mean.
// Techniques: 16.
TEST(TwinBlend, ReciprocalLengthIsTheRecursionOfTheWeight) {
  Settings settings = byLength(0.0f);
  settings.blend.length = LengthRule::Reciprocal;
  double weight = 0.5; // of history, in the second frame
  const std::vector<Step> steps = accumulate(randomSamples(40), settings);
  for (std::size_t frame = 1; frame < steps.size(); ++frame, weight = 1.0 / (2.0 - weight)) {
    EXPECT_NEAR(weight, static_cast<double>(frame) / static_cast<double>(frame + 1), 1e-12);
    EXPECT_NEAR(steps[frame].length, 1.0 / (1.0 - weight), 1e-4);
  }
  BlendInputs mix{.alpha = 0.5f, .historyLength = 30.0f};
  EXPECT_EQ(blend(settings, mix).historyLength, 2.0f) << "a large α starts the count again";
  mix.alpha = 0.0f;
  EXPECT_EQ(blend(settings, mix).historyLength, 30.0f) << "nothing was added";
  mix.alpha = 0.0625f;
  mix.confidence = 0.25f;
  EXPECT_EQ(blend(settings, mix).historyLength, 4.0f) << "κ is no part of the count";
}

// Invariant 51: Bevy's schedule.
// Techniques: 16.
TEST(TwinBlend, ConfidenceFreezesEarlySamples) {
  Settings settings = test::plainSettings();
  settings.weight = {
      .source = AlphaSource::Confidence, .minimum = 0.0f, .sourceMax = 0.1f, .sourceMin = 0.015f};
  settings.blend.length = LengthRule::Confidence;
  Inputs inputs = test::constantInputs(1, 1, glm::vec3(0.5f));
  test::advance(inputs, settings, 0, 0);
  double samples = 1.0; // what the weights average, N of manual §16
  const std::array expected{0.0909, 0.0476, 0.0323, 0.0244, 0.0196, 0.0164, 0.015, 0.015};
  for (int frame = 1; frame <= 100; ++frame) {
    const PixelRecord record = test::advance(inputs, settings, 0, 0);
    const double alpha = at(record, IntermediateId::alpha).x;
    if (frame <= 8) {
      EXPECT_NEAR(alpha, expected[static_cast<std::size_t>(frame - 1)], 5e-5) << frame;
    }
    EXPECT_EQ(at(record, IntermediateId::historyLength).x, 1.0f + 10.0f * static_cast<float>(frame));
    samples = 1.0 / (alpha * alpha + (1.0 - alpha) * (1.0 - alpha) / samples);
    if (frame == 7) {
      EXPECT_NEAR(samples, 1.6, 0.05);
    }
    if (frame == 100) {
      EXPECT_NEAR(samples, 22.7, 0.05);
    }
  }
  inputs.motion.at(0, 0)[1] = 0.02f;
  const PixelRecord moved = test::advance(inputs, settings, 0, 0);
  EXPECT_EQ(at(moved, IntermediateId::alpha).x, 0.1f);
  EXPECT_EQ(at(moved, IntermediateId::historyLength).x, 1.0f);
}

} // namespace
} // namespace taa::twin
