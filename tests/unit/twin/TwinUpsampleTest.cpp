// The twin's upsampling against numbers worked out by hand (manual §22).
#include "core/taa/twin/Upsample.h"

#include "core/render/FrameInputs.h"
#include "core/taa/twin/Stages.h"
#include "tests/support/frames/TwinInputs.h"

#include <gtest/gtest.h>

#include <cmath>

namespace taa {
namespace {

using twin::at;
using twin::upsample;

/// 8 × 8 texels of a picture of 16 × 16, gray 1 but for one texel.
twin::Inputs half() {
  twin::Inputs inputs = test::constantInputs(8, 8, glm::vec3(1.0f));
  inputs.outputPx = {16, 16};
  test::setColor(inputs.color, 3, 3, glm::vec3(2.0f));
  return inputs;
}

float confidence(UpsampleKernel kernel, const glm::vec2& d, float speed = 0.0f) {
  return upsample(half(), kernel, {{3, 3}, d, {3, 3}}, speed).confidence;
}

TEST(TwinUpsample, DrawsTheNextLargerSize) {
  const auto drawn = [](int width, int height, float scale) { return drawnSize({width, height}, scale); };
  EXPECT_EQ(drawn(101, 57, 1.0f), glm::ivec2(101, 57));
  EXPECT_EQ(drawn(101, 57, 0.5f), glm::ivec2(51, 29));
  EXPECT_EQ(drawn(100, 300, 0.67f), glm::ivec2(67, 201)); // the float is a little more than 0.67
  EXPECT_EQ(drawn(101, 57, 0.67f), glm::ivec2(68, 39));
  EXPECT_EQ(drawn(1280, 720, 0.75f), glm::ivec2(960, 540));
  EXPECT_EQ(drawn(4, 4, 0.5f), glm::ivec2(2, 2));
}

// Techniques: 8.9.
TEST(TwinUpsample, FindsTheNearestSampleAndTheWayToIt) {
  twin::Inputs inputs = half();
  // Center ½ of the picture is ¼ of the drawing; sample 0 lies at ½.
  EXPECT_EQ(placeOf(inputs, {0, 0}).texel, glm::ivec2(0));
  EXPECT_EQ(placeOf(inputs, {0, 0}).offset, glm::vec2(0.25f));
  EXPECT_EQ(placeOf(inputs, {7, 7}).texel, glm::ivec2(3));
  EXPECT_EQ(placeOf(inputs, {7, 7}).offset, glm::vec2(-0.25f));
  // Content displaced by +j: sample k holds what lies at k + ½ − j. At 3.75, sample 4 lies at 4.125 then.
  inputs.jitterPx = {0.375f, -0.25f};
  EXPECT_EQ(placeOf(inputs, {7, 7}).texel, glm::ivec2(4, 3));
  EXPECT_EQ(placeOf(inputs, {7, 7}).offset, glm::vec2(0.375f, 0.0f));
  EXPECT_EQ(placeOf(inputs, {7, 7}).still, glm::ivec2(3)) << "where nothing is jittered";
  // Beyond the last sample there is none nearer.
  inputs.jitterPx = {0.5f, -0.5f};
  EXPECT_EQ(placeOf(inputs, {15, 0}).texel, glm::ivec2(7, 0));
  EXPECT_EQ(placeOf(inputs, {15, 0}).offset, glm::vec2(-0.75f, 0.75f));
}

TEST(TwinUpsample, MeasuresMotionInPixelsOfThePicture) {
  twin::Inputs inputs = half();
  inputs.motion.at(2, 2)[0] = 3.0f;
  inputs.motion.at(2, 2)[1] = -0.5f;
  inputs.motion.at(4, 4)[0] = inputs.motion.at(4, 4)[1] = twin::kNoPreviousPosition;
  const DilateSettings own{DilateMethod::None};
  EXPECT_EQ(dilateMotion(inputs, own, {2, 2}).motion, glm::vec2(6.0f, -1.0f));
  EXPECT_EQ(dilateMotion(inputs, own, {4, 4}).motion, glm::vec2(twin::kNoPreviousPosition)) << "a mark";
}

// Techniques: 22.1.
TEST(TwinUpsample, TrustsTheNearestSampleByItsDistance) {
  const auto kappa = [](float x, float y, float speed = 0.0f) {
    return confidence(UpsampleKernel::SampleWeight, {x, y}, speed);
  };
  EXPECT_EQ(kappa(0.0f, 0.0f), 1.0f);
  EXPECT_EQ(kappa(0.25f, 0.0f), 1.0f - 0.0625f / 0.5f);
  EXPECT_EQ(kappa(0.5f, 0.5f), 0.0f);
  EXPECT_EQ(kappa(0.5f, 0.5f, 0.5f), 0.5f) << "smoothstep of the speed";
  EXPECT_EQ(kappa(0.5f, 0.5f, 1.0f), 1.0f);
  const auto nearest = upsample(half(), UpsampleKernel::SampleWeight, {{3, 3}, {0.4f, 0.2f}, {3, 3}}, 0.0f);
  EXPECT_EQ(nearest.color, glm::vec3(2.0f));
}

// Techniques: 22.2.
TEST(TwinUpsample, LanczosCountsTheSamplesWithinTwoPixels) {
  const auto at = [](float x, float y) {
    return upsample(half(), UpsampleKernel::Lanczos2, {{3, 3}, {x, y}, {3, 3}}, 0.0f);
  };
  EXPECT_EQ(at(0.0f, 0.0f).color, glm::vec3(2.0f)) << "interpolates: its zeros are at the other samples";
  EXPECT_EQ(at(0.0f, 0.0f).confidence, 1.0f);
  EXPECT_EQ(at(0.5f, 0.0f).confidence, 0.0f) << "halfway all lie on zeros";
  EXPECT_EQ(at(0.5f, 0.0f).color, glm::vec3(2.0f)) << "the nearest, should history be rejected";
  // A quarter: ½ and 1½ px of the picture, L(½) = 0.75·3.75³/64 and L(1½) = −1.25·1.75³/64.
  const float near = 0.75f * 3.75f * 3.75f * 3.75f / 64.0f, far = -1.25f * 1.75f * 1.75f * 1.75f / 64.0f;
  EXPECT_FLOAT_EQ(at(0.25f, 0.0f).confidence, near + far);
  EXPECT_EQ(at(0.25f, 0.0f).color, glm::vec3(2.0f)) << "1 + near/(near + far) is more than any sample";
}

// Techniques: 22.3.
TEST(TwinUpsample, HdrpTrustsASampleInABoxThatHoldsAnyNearestOne) {
  EXPECT_EQ(confidence(UpsampleKernel::Hdrp, {0.5f, -0.5f}), 1.0f) << "as far as the nearest can be";
  EXPECT_EQ(confidence(UpsampleKernel::Hdrp, {0.5f, -1.0f}), 1.0f) << "½/r";
  EXPECT_EQ(confidence(UpsampleKernel::Hdrp, {0.5f, -1.001f}), 0.0f);
  const float color = upsample(half(), UpsampleKernel::Hdrp, {{3, 3}, {0.0f, 0.0f}, {3, 3}}, 0.0f).color.x;
  const float edge = (0.9656852f - 1.0f) * (0.9656852f - 1.0f); // what a sample at one pixel or more weighs
  EXPECT_FLOAT_EQ(color, 1.0f + 1.0f / (1.0f + 8.0f * edge));
}

// Techniques: 22.3.
TEST(TwinUpsample, HdrpsGaussianTrustsASampleByItsDistance) {
  const auto kappa = [](float x, float y) { return confidence(UpsampleKernel::HdrpGaussian, {x, y}); };
  EXPECT_EQ(kappa(0.0f, 0.0f), 1.0f) << "4 times 1, at most 1";
  // 4·2^(−3.125‖x‖²), x twice as many px of the picture as render px: 1 within 0.8 px.
  EXPECT_EQ(kappa(0.375f, 0.0f), 1.0f);
  EXPECT_NEAR(kappa(0.5f, 0.0f), 4.0 * std::exp2(-3.125), 2e-7);
  EXPECT_NEAR(kappa(0.5f, -0.5f), 4.0 * std::exp2(-6.25), 2e-8);
  EXPECT_NEAR(kappa(0.25f, 0.375f), 4.0 * std::exp2(-3.125 * (0.25 + 0.5625)), 2e-7);
  // Samples weigh what HDRP's others do.
  const twin::Place place{{3, 3}, {0.125f, 0.25f}, {3, 3}};
  EXPECT_EQ(upsample(half(), UpsampleKernel::HdrpGaussian, place, 0.0f).color,
            upsample(half(), UpsampleKernel::Hdrp, place, 0.0f).color);
}

// Techniques: 22.4.
TEST(TwinUpsample, Fsr2IsRoundAndKeepsHistoryWhereItsSumIsNegative) {
  EXPECT_EQ(confidence(UpsampleKernel::Fsr2, {0.5f, 0.5f}), 0.0f) << "four samples on the negative lobe";
  // Scaled by 1.99, not 2: the cross at 1.99, the diagonals beyond 2.
  const float x2 = 1.99f * 1.99f;
  EXPECT_NEAR(confidence(UpsampleKernel::Fsr2, {0.0f, 0.0f}),
              1.0f + 4.0f * (x2 - 1.0f) * (x2 - 4.0f) * (x2 - 4.0f) * (x2 - 4.0f) / 64.0f, 1e-6f);
  twin::Inputs inputs = half();
  test::setColor(inputs.color, 1, 3, glm::vec3(1000.0f)); // two to the left: reached where d > 0
  inputs.outputPx = {8, 8};
  const auto at = [&](float x) {
    return upsample(inputs, UpsampleKernel::Fsr2, {{3, 3}, {x, 0.0f}, {3, 3}}, 0.0f);
  };
  EXPECT_EQ(at(0.25f).color, glm::vec3(1.0f)) << "pulled down by the lobe, kept within the nine";
  EXPECT_GT(at(-0.25f).color.x, 1.0f) << "not reached from the other side";
}

TEST(TwinUpsample, AConfidenceOfNothingKeepsHistory) {
  for (const ToneWeight tone : {ToneWeight::None, ToneWeight::Luma, ToneWeight::ReinhardChannel}) {
    Settings settings = test::plainSettings();
    settings.inputs.renderScale = 0.5f;
    settings.blend.tone = tone;
    twin::Inputs inputs = half();
    test::setHistory(inputs, glm::vec3(0.3f, 0.7f, 5.1f), 7.0f);
    inputs.jitterPx = {-0.25f, 0.0f}; // sample 3 lies at 3.75, pixel 6 at 3.25
    const twin::PixelRecord kept = twin::resolvePixel(inputs, settings, 6, 7);
    EXPECT_EQ(at(kept, IntermediateId::sampleConfidence).x, 0.0f);
    EXPECT_EQ(at(kept, IntermediateId::alpha).x, 0.0f);
    EXPECT_EQ(glm::vec3(at(kept, IntermediateId::resolved)), glm::vec3(0.3f, 0.7f, 5.1f));
    EXPECT_FLOAT_EQ(at(kept, IntermediateId::historyLength).x, 7.0f);
    settings.validate.depth = Switch::On;
    for (float& depth : inputs.historySurface.pixels) depth = 9.0f; // another surface
    const twin::PixelRecord rejected = twin::resolvePixel(inputs, settings, 6, 7);
    EXPECT_EQ(at(rejected, IntermediateId::alpha).x, 1.0f);
    EXPECT_EQ(glm::vec3(at(rejected, IntermediateId::resolved)),
              glm::vec3(at(rejected, IntermediateId::currentFiltered)));
  }
}

} // namespace
} // namespace taa
