// What the sources' own formulas give for hand-made pixels (manual §26 and the rows that cite a source):
// every number here was computed by hand from the printed formula.
#include "tests/support/frames/TwinInputs.h"

#include "core/taa/twin/Stages.h"

#include <gtest/gtest.h>

#include <cmath>

namespace taa::twin {
namespace {

/// A gray pixel of 0.5 on a history of 0.6, resolved.
float mixedGray(const Settings& settings) {
  Inputs inputs = test::constantInputs(3, 3, glm::vec3(0.5f));
  test::setHistory(inputs, glm::vec3(0.6f), 8.0f);
  return at(resolvePixel(inputs, settings, 1, 1), IntermediateId::resolved).x;
}

// Raptor's shader was run with these two grays and gave 0.520 (manual §26, D1). Compressed by their largest
// channel they are 1/3 and 3/8: u = 8/9, α = 64/81, weights 1/(1 + 1/3) and 1/(1 + 3/8).
// Techniques: 13.12, D1.
TEST(PrintedNumbers, RaptorsShaderMixesHalfAndSixTenthsToItsNumber) {
  Settings settings = test::plainSettings();
  settings.weight = {AlphaSource::LumaDifferenceAsPrinted, 0.1f, 0.0f};
  settings.blend.tone = ToneWeight::LumaAsPrinted;
  EXPECT_NEAR(mixedGray(settings), 0.520482f, 1e-6f);
  // With the weights as they were meant about 0.58 is right.
  settings.weight.source = AlphaSource::LumaDifferenceCompressed;
  settings.weight.sourceMax = 1.0f;
  settings.weight.sourceMin = 0.0f;
  EXPECT_NEAR(mixedGray(settings), 0.578498f, 1e-6f);
}

// Playdead's difference is of the colors themselves: u = 1 − 0.1/0.6, α = u².
TEST(PrintedNumbers, PlaydeadsLumaIsNotCompressed) {
  Settings settings = test::plainSettings();
  settings.weight = {AlphaSource::LumaDifference, 0.1f, 0.0f};
  settings.weight.sourceMax = 0.0f;
  settings.weight.sourceMin = 1.0f;
  EXPECT_NEAR(mixedGray(settings), 0.6f - 0.1f * 25.0f / 36.0f, 1e-6f);
}

// Source 000: lerp(α − 0.025, 1, ‖v‖²) with v in fractions of the picture (13.4).
// Techniques: D11.
TEST(PrintedNumbers, Source000StartsBelowAlpha) {
  WeightSettings settings{.source = AlphaSource::Constant, .alpha = 0.1f, .minimum = 0.0f};
  settings.motion = MotionAlpha::SquaredAsPrinted;
  const auto alpha = [&settings](const glm::vec2& motionUv) {
    WeightInputs weighed;
    weighed.motionUv = motionUv;
    return blendWeight(settings, 4.0f, 0.0f, weighed).alpha;
  };
  EXPECT_NEAR(alpha({0.0f, 0.0f}), 0.075f, 1e-7f);
  EXPECT_NEAR(alpha({0.3f, 0.4f}), 0.30625f, 1e-7f) << "0.075 + 0.25 × 0.925";
  EXPECT_EQ(alpha({1.0f, 0.5f}), 1.0f);
  settings.alpha = 0.02f;
  EXPECT_EQ(alpha({0.0f, 0.0f}), 0.0f) << "and not less than nothing";
}

Settings oneSided() {
  Settings settings = test::plainSettings();
  settings.validate.offScreen = OffScreen::OneSided;
  return settings;
}

/// Pixel (1, 1) of three, which follows a motion of so many px to the right.
PixelRecord movedBy(const Settings& settings, float px) {
  Inputs inputs = test::constantInputs(3, 3, glm::vec3(0.25f));
  test::setHistory(inputs, glm::vec3(0.7f), 8.0f);
  for (int k = 0; k < 9; ++k) inputs.motion.at(k % 3, k / 3)[0] = px;
  return resolvePixel(inputs, settings, 1, 1);
}

// Source 002's first listing: what does not pass x > 0 keeps 100 % of its history (D9).
// Techniques: 5.7, D9.
TEST(PrintedNumbers, BeyondTheLeftEdgeSource002KeepsAllOfTheHistory) {
  for (const ToneWeight tone :
       {ToneWeight::None, ToneWeight::Luma, ToneWeight::ReinhardChannel, ToneWeight::Pq}) {
    Settings settings = oneSided();
    settings.blend.tone = tone;
    const PixelRecord outside = movedBy(settings, 2.5f);
    EXPECT_EQ(at(outside, IntermediateId::rejectReason).x, static_cast<float>(RejectReason::OffScreen));
    EXPECT_EQ(at(outside, IntermediateId::alpha).x, 0.0f);
    EXPECT_EQ(glm::vec3(at(outside, IntermediateId::resolved)), glm::vec3(0.7f));
    EXPECT_EQ(at(outside, IntermediateId::historyLength).x, 8.0f);
  }
  EXPECT_EQ(at(movedBy(oneSided(), 1.5f), IntermediateId::alpha).x, 0.0f) << "x = 0 does not pass";
  EXPECT_EQ(at(movedBy(oneSided(), -2.5f), IntermediateId::alpha).x, 0.1f) << "nobody looks to the right";
  Settings both = oneSided();
  both.validate.offScreen = OffScreen::Reject;
  EXPECT_EQ(at(movedBy(both, 2.5f), IntermediateId::alpha).x, 1.0f) << "corrected";
}

/// Five by five texels at one depth, 3 m, whose motion says where they are.
Inputs flatTexels() {
  Inputs inputs = test::constantInputs(5, 5, glm::vec3(0.5f));
  for (int k = 0; k < 25; ++k) {
    inputs.motion.at(k % 5, k / 5)[0] = static_cast<float>(k % 5);
    inputs.motion.at(k % 5, k / 5)[1] = static_cast<float>(k / 5);
  }
  return inputs;
}

glm::vec2 motionOf(const Inputs& inputs, DilateMethod method, DilateTies ties, Switch upLeft = Switch::Off) {
  return dilateMotion(inputs, {method, ties, upLeft}, {2, 2}).motion;
}

// Source 002 mixes by step(depth, closest), which is 1 for equal depths: of × the last, (1, 1). Playdead
// starts with the first of nine and takes only nearer ones.
// Techniques: 4.1, 4.3.
TEST(PrintedNumbers, OfEqualDepthsEachSourceTakesItsOwn) {
  const Inputs inputs = flatTexels();
  EXPECT_EQ(motionOf(inputs, DilateMethod::ClosestX, DilateTies::Last), glm::vec2(3.0f, 3.0f));
  EXPECT_EQ(motionOf(inputs, DilateMethod::Closest3x3, DilateTies::First), glm::vec2(1.0f, 1.0f));
  EXPECT_EQ(motionOf(inputs, DilateMethod::ClosestX2, DilateTies::Last), glm::vec2(4.0f, 4.0f));
  for (const DilateMethod method : {DilateMethod::Closest3x3, DilateMethod::ClosestCross,
                                    DilateMethod::ClosestX, DilateMethod::Farthest3x3})
    EXPECT_EQ(motionOf(inputs, method, DilateTies::Center), glm::vec2(2.0f, 2.0f));
  EXPECT_EQ(motionOf(inputs, DilateMethod::ClosestCross, DilateTies::First), glm::vec2(2.0f, 1.0f));
}

TEST(PrintedNumbers, TiesDoNotMatterWhereOneIsNearer) {
  Inputs inputs = flatTexels();
  inputs.depth.at(1, 3)[0] *= 2.0f;
  for (const DilateTies ties : {DilateTies::Center, DilateTies::First, DilateTies::Last})
    EXPECT_EQ(motionOf(inputs, DilateMethod::Closest3x3, ties), glm::vec2(1.0f, 3.0f));
}

// Raptor's loop has x outside: of two equally near ones (−1, 0) comes before (0, −1).
TEST(PrintedNumbers, RaptorSearchesColumnByColumn) {
  Inputs inputs = flatTexels();
  inputs.depth.at(1, 2)[0] *= 2.0f;
  inputs.depth.at(2, 1)[0] *= 2.0f;
  EXPECT_EQ(motionOf(inputs, DilateMethod::Closest3x3AsPrinted, DilateTies::Center), glm::vec2(1.0f, 2.0f));
  EXPECT_EQ(motionOf(inputs, DilateMethod::Closest3x3, DilateTies::Center), glm::vec2(2.0f, 1.0f));
}

// Godot's search is for the least depth, the farthest once depth is reversed, and reads one texel up-left of
// it.
// Techniques: 4.1.
TEST(PrintedNumbers, GodotReadsUpLeftOfTheLeastDepth) {
  Inputs inputs = flatTexels();
  inputs.depth.at(3, 2)[0] *= 0.5f;
  inputs.depth.at(1, 1)[0] *= 2.0f;
  EXPECT_EQ(motionOf(inputs, DilateMethod::Farthest3x3, DilateTies::First, Switch::On),
            glm::vec2(2.0f, 1.0f));
  EXPECT_EQ(motionOf(inputs, DilateMethod::Closest3x3, DilateTies::First, Switch::On), glm::vec2(0.0f, 0.0f));
  EXPECT_EQ(motionOf(flatTexels(), DilateMethod::Farthest3x3, DilateTies::First, Switch::On),
            glm::vec2(0.0f, 0.0f));
}

// Godot's weights are 1/(1 + Y) after c/(1 + c): a white of 1 among eight blacks is ½ there and weighs 2/3,
// so that the mean is (½ · 2/3)/(8 + 2/3) = 1/26.
// Techniques: 10.7.
TEST(PrintedNumbers, GodotWeighsMomentsByTheCompressedLuma) {
  Settings settings = test::plainSettings();
  settings.space = {ColorSpace::YCoCg, ToneSpace::ReinhardChannel};
  settings.neighborhood.box = BoxKind::Variance;
  Inputs inputs = test::constantInputs(3, 3, glm::vec3(0.0f));
  test::setColor(inputs.color, 0, 2, glm::vec3(1.0f));
  const auto mean = [&](MomentWeights weights) {
    settings.neighborhood.weights = weights;
    return measureNeighborhood(inputs, settings, glm::vec3(0.0f), {1, 1}).mean.x;
  };
  EXPECT_NEAR(mean(MomentWeights::BoxLuma), 1.0f / 26.0f, 1e-8f);
  EXPECT_NEAR(mean(MomentWeights::Luma), 0.25f / 8.5f, 1e-8f) << "1/(1 + 1) of the scene's own";
}

// Godot's luma is 0.299 R + 0.587 G + 0.114 B of c/(1 + c), at least 0.0001, measured against 1.001.
// Techniques: 13.11.
TEST(PrintedNumbers, GodotCalmsByLumaOfRec601) {
  Settings settings = test::plainSettings();
  settings.weight.lumaFlicker = Switch::On;
  settings.weight.flickerScale = FlickerScale::Compressed;
  Inputs inputs = test::constantInputs(3, 3, {1.0f, 0.0f, 0.0f});
  test::setHistory(inputs, glm::vec3(0.0f), 8.0f);
  const float factor = at(resolvePixel(inputs, settings, 1, 1), IntermediateId::alphaLumaFlicker).x;
  constexpr double kRest = 1.0 - (0.1495 - 0.0001) / 1.001;
  EXPECT_NEAR(factor, kRest * kRest, 1e-6);
}

/// As Godot counts: N up to 16, read bilinearly, taken from by what is rejected.
Settings godotCount() {
  Settings settings = test::plainSettings();
  settings.history.length = LengthFrom::Bilinear;
  settings.validate.action = RejectAction::Decay;
  settings.validate.velocity = VelocityTest::Vector;
  settings.validate.velocityLimit = 2.5f;
  settings.validate.velocityGain = 0.01f;
  settings.weight = {AlphaSource::HistoryLength, 0.1f, 0.0f};
  settings.blend.length = LengthRule::CountTo16;
  return settings;
}

// Techniques: 16.
TEST(PrintedNumbers, GodotReadsTheCountBilinearly) {
  Inputs inputs = test::constantInputs(4, 4, glm::vec3(0.5f));
  test::setHistory(inputs, glm::vec3(0.5f), 0.0f);
  inputs.historySurface.at(2, 1)[0] = 4.0f;
  inputs.historySurface.at(1, 2)[0] = 8.0f;
  inputs.historySurface.at(2, 2)[0] = 12.0f;
  const HistorySample read = sampleHistory(inputs, godotCount().history, {1.75f, 2.0f}, {1, 1});
  EXPECT_EQ(read.historyLength, 5.0f) << "a quarter right of, half below (1, 1): the middle of 1 and 9";
}

// Techniques: 16.
TEST(PrintedNumbers, GodotCountsFromTheSecondFrameTo16) {
  Inputs inputs = test::constantInputs(1, 1, glm::vec3(0.5f));
  for (int frame = 0; frame < 24; ++frame) {
    const PixelRecord record = test::advance(inputs, godotCount(), 0, 0);
    const float expected = static_cast<float>(frame < 16 ? frame : 16);
    EXPECT_EQ(at(record, IntermediateId::historyLength).x, expected) << frame;
    if (frame == 0) continue;
    EXPECT_EQ(at(record, IntermediateId::alpha).x, 1.0f / (frame < 17 ? float(frame) : 17.0f)) << frame;
  }
}

// A change of 52.5 px rejects (52.5 − 2.5) · 0.01 = ½: N falls from 8 to 4, and α is 1/5 + ½.
// Techniques: 12.5.
TEST(PrintedNumbers, WhatGodotRejectsTakesFromTheCountAndAddsToAlpha) {
  Inputs inputs = test::constantInputs(1, 1, glm::vec3(0.5f));
  test::setHistory(inputs, glm::vec3(0.5f), 8.0f);
  inputs.historyMotion = Image(1, 1, 2);
  inputs.historyMotion.at(0, 0)[0] = 52.5f;
  const PixelRecord record = resolvePixel(inputs, godotCount(), 0, 0);
  EXPECT_NEAR(at(record, IntermediateId::alphaInvalid).x, 0.5f, 1e-6f);
  EXPECT_NEAR(at(record, IntermediateId::historyKeptLength).x, 4.0f, 1e-5f);
  EXPECT_NEAR(at(record, IntermediateId::alpha).x, 0.7f, 1e-6f);
  EXPECT_NEAR(at(record, IntermediateId::historyLength).x, 5.0f, 1e-5f);
}

// 9 px across of 1920 and 6 px down of 1080 are 0.0046875 and 0.0055556 in texture coordinates, together
// 0.0072689, which Godot holds against 128/1080. DiligentFX holds 1/256 of the height, 4.21875 px of 1080,
// against the pixels of a picture of as many lines.
TEST(PrintedNumbers, SpeedsMayBeCountedInThePicture) {
  const glm::vec2 motion(9.0f, 6.0f);
  const float px = std::sqrt(117.0f);
  EXPECT_EQ(speedIn(SpeedUnit::Pixels, px, motion, {1920, 1080}), px);
  EXPECT_NEAR(speedIn(SpeedUnit::Picture1080, px, motion, {1920, 1080}), 7.8504080f, 1e-5f);
  EXPECT_EQ(speedIn(SpeedUnit::Lines1080, 3.0f, {3.0f, 0.0f}, {960, 540}), 6.0f);
  WeightSettings source002{.source = AlphaSource::Constant, .alpha = 0.05f, .minimum = 0.0f};
  source002.motion = MotionAlpha::Added;
  source002.motionSpeed = 1.08f;
  source002.motionSpeedIn = SpeedUnit::Picture1080;
  const WeightInputs weighed{.speed = 0.5f, .picturePx = {1920, 1080}, .motion = {0.4f, 0.3f}};
  // 0.05 + 1000·‖(0.4/1920, 0.3/1080)‖
  EXPECT_NEAR(blendWeight(source002, 4.0f, 0.0f, weighed).alpha, 0.05f + 0.3472222f, 1e-6f);
}

} // namespace
} // namespace taa::twin
