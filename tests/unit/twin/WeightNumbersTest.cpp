// The published numbers of α's sources and of accumulation (invariants 46, 47, 50, 55, 58, 59).
#include "tests/support/frames/TwinInputs.h"

#include "core/taa/twin/Color.h"
#include "core/taa/twin/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace taa::twin {
namespace {

WeightInputs lumas(float current, float history) {
  WeightInputs weighed;
  weighed.hasHistory = true;
  weighed.lumaCurrent = current;
  weighed.lumaHistory = history;
  return weighed;
}

/// The history weight 1 − α of Playdead, whose limits are .88 and .97.
float playdead(float current, float history) {
  WeightSettings settings;
  settings.source = AlphaSource::LumaDifference;
  settings.sourceMax = 0.12f;
  settings.sourceMin = 0.03f;
  settings.minimum = 0.0f;
  return 1.0f - blendWeight(settings, 5.0f, 0.0f, lumas(current, history)).alpha;
}

// Techniques: 13.10.
TEST(WeightNumbers, TheLumaDifferenceOfPlaydeadTrustsWhatLooksAlike) {
  EXPECT_NEAR(playdead(0.7f, 0.7f), 0.97f, 1e-6f);
  EXPECT_NEAR(playdead(0.0f, 1.0f), 0.88f, 1e-6f);
  EXPECT_NEAR(playdead(0.25f, 0.5f), 0.9025f, 1e-6f);
  float last = 1.0f;
  for (int i = 0; i <= 16; ++i) {
    const float weight = playdead(0.5f, 0.5f + 0.0625f * float(i));
    EXPECT_LT(weight, last);
    last = weight;
  }
}

// Techniques: 13.12.
TEST(WeightNumbers, TheLumaDifferenceAsPrintedTrustsWhatDiffers) {
  WeightSettings settings;
  settings.source = AlphaSource::LumaDifferenceAsPrinted;
  settings.minimum = 0.0f;
  const auto alpha = [&settings](float history) { // of grays over 1 + their largest channel
    WeightInputs weighed = lumas(0.5f, history);
    weighed.maxCurrent = 0.5f / 1.5f;
    weighed.maxHistory = history / (1.0f + history);
    return blendWeight(settings, 5.0f, 0.0f, weighed).alpha;
  };
  EXPECT_EQ(alpha(0.5f), 1.0f);
  EXPECT_GT(alpha(0.5f), alpha(0.6f));
  EXPECT_GT(alpha(0.6f), alpha(1.0f));
}

/// α' / α of Karis's term for history luma `history` and walls 1 and 2.
float nearClampFactor(float history) {
  WeightSettings settings;
  settings.nearClamp = Switch::On;
  WeightInputs weighed = lumas(1.5f, history);
  weighed.boxHistoryRaw = history;
  weighed.boxLow = 1.0f;
  weighed.boxHigh = 2.0f;
  return blendWeight(settings, 5.0f, 0.0f, weighed).nearClamp;
}

// Techniques: 13.13.
TEST(WeightNumbers, NearTheWallsHistoryIsKeptAndFarOutsideItIsNot) {
  EXPECT_EQ(nearClampFactor(1.0f), 0.0f);
  EXPECT_EQ(nearClampFactor(2.0f), 0.0f);
  EXPECT_FLOAT_EQ(nearClampFactor(1.5f), 1.0f / 3.0f);
  EXPECT_GT(nearClampFactor(1e6f), 0.99999f);
}

// Techniques: 13.4, D11.
TEST(WeightNumbers, SquaredMotionAsPrintedIsNothing) {
  WeightSettings settings;
  settings.motion = MotionAlpha::SquaredAsPrinted;
  WeightInputs weighed = lumas(0.5f, 0.5f);
  weighed.speed = 50.0f;
  weighed.motionUv = {50.0f / 1920.0f, 0.0f};
  EXPECT_NEAR(blendWeight(settings, 5.0f, 0.0f, weighed).motion, 6.8e-4f, 2e-6f);
  settings.motion = MotionAlpha::Squared; // in pixels it does something
  settings.motionSpeed = 64.0f;
  EXPECT_FLOAT_EQ(blendWeight(settings, 5.0f, 0.0f, weighed).motion, 0.6103515625f);
}

// Techniques: 13.5.
TEST(WeightNumbers, AddedMotionIsThatOfSource002) {
  WeightSettings settings;
  settings.source = AlphaSource::Constant;
  settings.alpha = 0.05f;
  settings.minimum = 0.0f;
  settings.motion = MotionAlpha::Added;
  const auto alpha = [&settings](float k, float speed) { // of a picture 1920 px wide
    settings.motionSpeed = 1920.0f / k;
    WeightInputs weighed = lumas(0.5f, 0.5f);
    weighed.speed = speed;
    return blendWeight(settings, 5.0f, 0.0f, weighed).alpha;
  };
  EXPECT_NEAR(alpha(100.0f, 1.0f), 0.1021f, 5e-5f);
  EXPECT_NEAR(alpha(1000.0f, 1.0f), 0.5708f, 5e-5f);
  EXPECT_EQ(alpha(1000.0f, 2.0f), 1.0f) << "accumulation is off";
}

// Techniques: 13.14.
TEST(WeightNumbers, ContrastTrustsHistoryOnEdgesAndTheCurrentFrameOnFlatAreas) {
  WeightSettings settings;
  settings.source = AlphaSource::Contrast;
  settings.minimum = 0.0f;
  WeightInputs weighed = lumas(0.5f, 0.5f);
  weighed.boxCurrent = weighed.boxLow = weighed.boxHigh = 0.5f;
  EXPECT_FLOAT_EQ(blendWeight(settings, 5.0f, 0.0f, weighed).alpha, 0.75f);
  weighed.boxHigh = 2.0f;
  EXPECT_NEAR(blendWeight(settings, 5.0f, 0.0f, weighed).alpha, 0.15f, 1e-6f);
}

// Techniques: 13.8.
TEST(WeightNumbers, TheSkyTakesTheCurrentFrameAndDistanceTakesHistory) {
  WeightSettings settings;
  settings.source = AlphaSource::Depth;
  settings.alpha = 0.1f;
  settings.minimum = 0.0f;
  const auto alpha = [&settings](float depth) {
    WeightInputs weighed;
    weighed.depth = depth;
    return blendWeight(settings, 5.0f, 0.0f, weighed).alpha;
  };
  EXPECT_EQ(alpha(0.0f), 1.0f);
  EXPECT_FLOAT_EQ(alpha(0.25f), 0.025f + 0.075f * 0.5f);
  EXPECT_FLOAT_EQ(alpha(1.0f), 0.1f);
}

// Techniques: 13.15.
TEST(WeightNumbers, AFactorBySizeOfTheBoxIsOneWhereThereIsNoContrast) {
  WeightSettings settings;
  settings.historyContrast = Switch::On;
  WeightInputs weighed = lumas(0.5f, 0.5f);
  weighed.boxHistory = 0.5f;
  weighed.boxLow = weighed.boxHigh = 0.5f;
  EXPECT_EQ(blendWeight(settings, 5.0f, 0.0f, weighed).historyContrast, 1.0f);
  weighed.boxHigh = 1.0f; // 1/(1 + 0.5/0.5)
  EXPECT_EQ(blendWeight(settings, 5.0f, 0.0f, weighed).historyContrast, 0.5f);
  weighed.boxHistory = 0.0f; // divided by nothing: α stays, instead of 0 forever
  EXPECT_EQ(blendWeight(settings, 5.0f, 0.0f, weighed).historyContrast, 1.0f);
}

Settings constantAlpha(float alpha) {
  Settings settings = test::plainSettings();
  settings.weight = {AlphaSource::Constant, alpha, 0.0f};
  return settings;
}

TEST(WeightNumbers, HalfAGhostIsGoneAfterItsHalfLife) {
  const auto frames = [](float alpha) {
    Inputs inputs = test::constantInputs(1, 1, glm::vec3(1.0f));
    test::advance(inputs, constantAlpha(alpha), 0, 0);
    test::setColor(inputs.color, 0, 0, glm::vec3(0.0f));
    int n = 0;
    for (float rest = 1.0f; rest > 0.5f; ++n)
      rest = at(test::advance(inputs, constantAlpha(alpha), 0, 0), IntermediateId::resolved).x;
    return n;
  };
  EXPECT_EQ(frames(0.1f), 7);    // half-life 6.6
  EXPECT_EQ(frames(0.05f), 14);  // 13.5
  EXPECT_EQ(frames(0.04f), 17);  // 17.0
  EXPECT_EQ(frames(0.015f), 46); // 45.9
}

/// What the samples of a period of `count` weigh in the settled output, from the newest to the oldest.
std::vector<float> weightsOfPeriod(float alpha, int count) {
  Inputs inputs = test::constantInputs(1, 1, glm::vec3(0.0f));
  std::vector<float> weights;
  for (int frame = 0; frame < 40 * count; ++frame) {
    test::setColor(inputs.color, 0, 0, glm::vec3(frame % count == 0 ? 1.0f : 0.0f));
    const float value = at(test::advance(inputs, constantAlpha(alpha), 0, 0), IntermediateId::resolved).x;
    if (frame >= 39 * count) weights.push_back(value);
  }
  return weights;
}

TEST(WeightNumbers, APeriodSettlesToTheWeightsOfItsSamples) {
  const std::vector<float> eight = weightsOfPeriod(0.1f, 8), sixteen = weightsOfPeriod(0.1f, 16);
  EXPECT_NEAR(eight.front(), 0.1756f, 5e-5f);
  EXPECT_NEAR(eight.back(), 0.0840f, 5e-5f);
  EXPECT_NEAR(sixteen.front(), 0.1227f, 5e-5f);
  EXPECT_NEAR(sixteen.back(), 0.0253f, 5e-5f);
  EXPECT_NEAR(eight.front() - 1.0f / 8.0f, 0.0506f, 5e-5f); // ripple of one sample
  EXPECT_NEAR(sixteen.front() - 1.0f / 16.0f, 0.0602f, 5e-5f);
  const auto worst = [](const std::vector<float>& weights) { // what counts too much bright, the rest dark
    float sum = 0.0f;
    for (const float weight : weights) sum += std::max(0.0f, weight - 1.0f / float(weights.size()));
    return sum;
  };
  EXPECT_NEAR(worst(eight), 0.104f, 5e-4f);
  EXPECT_NEAR(worst(sixteen), 0.203f, 5e-4f);
}

// Techniques: D12.
TEST(WeightNumbers, LengthAsPrintedEndsAtTheGoldenRatio) {
  Settings settings = test::plainSettings();
  settings.weight = {AlphaSource::HistoryLength, 0.1f, 0.0f};
  settings.blend.length = LengthRule::VarianceAsPrinted;
  Inputs inputs = test::constantInputs(1, 1, glm::vec3(0.5f));
  float length = 0.0f;
  for (int frame = 0; frame < 60; ++frame)
    length = at(test::advance(inputs, settings, 0, 0), IntermediateId::historyLength).x;
  EXPECT_NEAR(length, (std::sqrt(5.0f) - 1.0f) / 2.0f, 1e-6f);
}

/// What is left of a firefly of 100 over black with α = 0.1.
glm::vec3 firefly(ToneWeight tone, const glm::vec3& bright) {
  Settings settings = constantAlpha(0.1f);
  settings.blend.tone = tone;
  Inputs inputs = test::constantInputs(1, 1, glm::vec3(0.0f));
  test::advance(inputs, settings, 0, 0);
  test::setColor(inputs.color, 0, 0, bright);
  return glm::vec3(at(test::advance(inputs, settings, 0, 0), IntermediateId::resolved));
}

// Techniques: 1.3, 14.3, 15.0, 15.3, 15.4.
TEST(WeightNumbers, EachToneWeightTamesAFireflyInItsOwnWay) {
  EXPECT_NEAR(firefly(ToneWeight::None, glm::vec3(100.0f)).x, 10.0f, 1e-5f);
  for (const ToneWeight tone : {ToneWeight::Luma, ToneWeight::ReinhardChannel, ToneWeight::MaxChannel})
    EXPECT_NEAR(firefly(tone, glm::vec3(100.0f)).x, 0.10989f, 5e-6f)
        << "gray: luma, channel and maximum agree";
  // Of a red one the luma is a fifth, and only the per-channel form changes the hue.
  const glm::vec3 red(100.0f, 10.0f, 10.0f);
  const glm::vec3 byLuma = firefly(ToneWeight::Luma, red), byMaximum = firefly(ToneWeight::MaxChannel, red),
                  byChannel = firefly(ToneWeight::ReinhardChannel, red);
  EXPECT_NEAR(byLuma.x / byLuma.y, 10.0f, 1e-4f);
  EXPECT_NEAR(byMaximum.x / byMaximum.y, 10.0f, 1e-3f);
  EXPECT_LT(byChannel.x / byChannel.y, 1.2f);
  EXPECT_GT(byLuma.x, 3.0f * byMaximum.x);
}

} // namespace
} // namespace taa::twin
