// Terms of α of the CPU twin (manual §13; invariants 51, 53, 59).
#include "tests/support/frames/TwinInputs.h"

#include "core/taa/TaaPass.h"
#include "core/taa/twin/Stages.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>

namespace taa::twin {
namespace {

WeightSettings constant(float alpha) {
  return {.source = AlphaSource::Constant, .alpha = alpha, .minimum = 0.0f};
}

float alphaOf(const WeightSettings& settings, const WeightInputs& weighed) {
  return blendWeight(settings, 4.0f, 0.0f, weighed).alpha;
}

// Manual 7.7: as the Gaussian of 7.4 weighs one sample.
// Techniques: 7.7.
TEST(TwinWeight, FallsWithTheDistanceOfTheSample) {
  WeightSettings settings = constant(0.5f);
  settings.sampleDistance = SampleDistance::Gaussian;
  const std::array<float, 9> gaussian = gaussianWeights(0.22f, {0.25f, -0.5f});
  WeightInputs weighed{.speed = 3.0f, .jitterPx = {0.25f, -0.5f}};
  EXPECT_EQ(blendWeight(settings, 4.0f, 0.0f, weighed).sampleDistance, gaussian[4]);
  EXPECT_EQ(alphaOf(settings, weighed), 0.5f * gaussian[4]);
  weighed.jitterPx = {};
  EXPECT_EQ(alphaOf(settings, weighed), 0.5f);
}

// Manual 13.6, Donut: α·max(smoothstep(0, 1, ‖v‖), 1 − ‖j‖²).
// Techniques: 13.6.
TEST(TwinWeight, DonutsParabolaIsLiftedByMotion) {
  WeightSettings settings = constant(0.5f);
  settings.sampleDistance = SampleDistance::Parabola;
  const auto at = [&](float speed) {
    return alphaOf(settings, {.speed = speed, .jitterPx = {0.5f, -0.25f}});
  };
  EXPECT_EQ(at(0.0f), 0.5f * 0.6875f);
  EXPECT_EQ(at(0.5f), 0.5f * 0.6875f) << "smoothstep is ½ there";
  EXPECT_EQ(at(0.75f), 0.5f * 0.84375f);
  EXPECT_EQ(at(1.0f), 0.5f);
  EXPECT_EQ(at(20.0f), 0.5f);
}

TEST(TwinWeight, TheResolveIsGivenTheSameDistancesAndTimes) {
  for (const glm::vec2 jitter : {glm::vec2(0.0f), glm::vec2(0.3f, -0.45f), glm::vec2(-0.5f, 0.5f)})
    for (const SampleDistance form :
         {SampleDistance::None, SampleDistance::Gaussian, SampleDistance::Parabola}) {
      WeightSettings settings = constant(0.5f);
      settings.sampleDistance = form;
      EXPECT_EQ(sampleDistanceFactor(form, jitter),
                blendWeight(settings, 4.0f, 0.0f, {.jitterPx = jitter}).sampleDistance);
    }
  EXPECT_EQ(frameEighths(1.0 / 60.0, 60.0f), 8);
  EXPECT_EQ(frameEighths(1.0 / 24.0, 60.0f), 20);
  EXPECT_EQ(frameEighths(1.0 / 144.0, 60.0f), 3);
  EXPECT_EQ(frameEighths(1.0 / 1000.0, 1.0f), 1) << "never none";
  EXPECT_EQ(frameEighths(1.0, 1000.0f), 64) << "never more than eight frames";
}

// Manual 13.6, HDRP: 2α at 50 px, and no more.
// Techniques: 13.6.
TEST(TwinWeight, MotionDoublesAlphaAndStops) {
  WeightSettings settings = constant(0.125f);
  settings.motion = MotionAlpha::Doubled;
  settings.motionSpeed = 50.0f;
  EXPECT_EQ(alphaOf(settings, {.speed = 0.0f}), 0.125f);
  EXPECT_EQ(alphaOf(settings, {.speed = 25.0f}), 0.1875f);
  EXPECT_EQ(alphaOf(settings, {.speed = 50.0f}), 0.25f);
  EXPECT_EQ(alphaOf(settings, {.speed = 5000.0f}), 0.25f);
  settings.alpha = 0.75f;
  EXPECT_EQ(alphaOf(settings, {.speed = 50.0f}), 1.0f);
  EXPECT_EQ(blendWeight(settings, 4.0f, 0.0f, {.speed = 50.0f}).motion, 0.25f);
}

// Manual 13.11: Godot measures after c/(1 + c) against 1.001, Filament against the larger luma.
// Techniques: 13.11.
TEST(TwinWeight, LumaMayBeMeasuredCompressed) {
  WeightSettings settings = constant(0.5f);
  settings.lumaFlicker = Switch::On;
  WeightInputs weighed{
      .hasHistory = true, .lumaCurrent = 0.1f, .lumaHistory = 0.0f, .compressedCurrent = 0.0909f};
  const auto squared = [](double x) { return x * x; };
  EXPECT_NEAR(alphaOf(settings, weighed), 0.5 * squared(1.0 - 0.1 / 0.101), 1e-7);
  settings.flickerScale = FlickerScale::Compressed;
  EXPECT_NEAR(alphaOf(settings, weighed), 0.5 * squared(1.0 - 0.0909 / 1.001), 1e-7);
}

// Invariant 53.
// Techniques: 13.19.
TEST(TwinWeight, TwoHalfFramesWeighAsOne) {
  WeightSettings settings = constant(0.36f);
  settings.frameRate = Switch::On;
  const auto at = [&](double rate) {
    return static_cast<double>(alphaOf(settings, {.stepSeconds = 1.0 / rate}));
  };
  EXPECT_EQ(at(60.0), static_cast<double>(0.36f)) << "at the reference it is α itself";
  const double half = at(120.0);
  EXPECT_NEAR(half, 0.2, 1e-7) << "1 − √(1 − 0.36)";
  EXPECT_NEAR(1.0 - (1.0 - half) * (1.0 - half), 0.36, 1e-7);
  EXPECT_NEAR(at(30.0), 1.0 - 0.64 * 0.64, 1e-7);
  for (const auto& [rate, eighths] :
       {std::pair(480.0, 1), std::pair(160.0, 3), std::pair(24.0, 20), std::pair(50.0, 10)})
    EXPECT_NEAR(at(rate), 1.0 - std::pow(0.64, eighths / 8.0), 5e-7) << rate;
  settings.referenceRate = 30.0f;
  EXPECT_EQ(at(30.0), static_cast<double>(0.36f));
  settings.alpha = 1.0f;
  EXPECT_EQ(at(24.0), 1.0);
  settings.alpha = 0.0f;
  EXPECT_EQ(at(24.0), 0.0);
  settings.frameRate = Switch::Off;
  EXPECT_EQ(blendWeight(constant(0.36f), 4.0f, 0.0f, {.stepSeconds = 1.0}).alpha, 0.36f);
}

// Manual 13.14, 14.2: β = lerp(0.25, 0.85, κ) of each channel.
// Techniques: 13.14.
TEST(TwinWeight, ContrastWeighsEachChannelByItself) {
  WeightSettings settings = constant(0.5f);
  settings.source = AlphaSource::ContrastPerChannel;
  Inputs inputs = test::constantInputs(3, 3, {0.5f, 0.5f, 0.5f});
  test::setHistory(inputs, {0.5f, 0.5f, 0.5f}, 4.0f);
  test::setColor(inputs.color, 0, 0, {0.5f, 0.75f, 100.0f});
  Settings all = test::plainSettings();
  all.weight = settings;
  const glm::vec4 weights = at(resolvePixel(inputs, all, 1, 1), IntermediateId::alphaChannels);
  EXPECT_NEAR(weights.x, 0.75, 1e-6) << "flat";
  EXPECT_NEAR(weights.y, 1.0 - (0.25 + 0.6 * 0.5), 1e-6) << "half of the color";
  EXPECT_NEAR(weights.z, 0.15, 1e-6) << "more than the color";
  all.weight.source = AlphaSource::Constant;
  const PixelRecord record = resolvePixel(inputs, all, 1, 1);
  EXPECT_EQ(glm::vec3(at(record, IntermediateId::alphaChannels)), glm::vec3(0.5f));
}

} // namespace
} // namespace taa::twin
