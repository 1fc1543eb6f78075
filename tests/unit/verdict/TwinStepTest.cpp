// What the CPU twin says of one step of a lineage, against the colors that it mixes.
#include "core/verdict/lineage/TwinStep.h"

#include "core/settings/Parameters.h"
#include "tests/support/frames/LineageShot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

using namespace taa;

namespace {

constexpr glm::ivec2 kPixel{6, 5};

glm::dvec3 sampled(const twin::Inputs& inputs, const PixelStep& step) {
  glm::dvec3 sum(0.0);
  for (const SampleRead& sample : step.samples)
    sum += sample.weight * glm::dvec3(glm::vec3(inputs.color.texel(sample.texel.x, sample.texel.y)));
  return sum;
}

void expectNear(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance, const char* what) {
  for (int channel = 0; channel < 3; ++channel)
    EXPECT_NEAR(actual[channel], expected[channel], tolerance) << what;
}

/// So little and so evenly different that no filter leaves the range of its samples.
twin::Inputs slope(int width, int height) {
  twin::Inputs inputs = test::constantInputs(width, height, glm::vec3(0.0f));
  for (int k = 0; k < width * height; ++k)
    test::setColor(
        inputs.color, k % width, k / width,
        glm::vec3(0.5f + 0.01f * static_cast<float>(k % width) - 0.007f * static_cast<float>(k / width)));
  return inputs;
}

} // namespace

TEST(TwinStep, SamplesAddUpToTheCurrentColorOfEveryFilter) {
  for (std::size_t filter = 0; filter < parameter("current.filter").choices.size(); ++filter)
    for (const CurrentSharpen sharpen :
         {CurrentSharpen::None, CurrentSharpen::Laplacian, CurrentSharpen::LaplacianAsPrinted})
      for (const Switch byLuma : {Switch::Off, Switch::On}) {
        Settings settings = test::plainSettings();
        settings.current.filter = static_cast<CurrentFilter>(filter);
        settings.current.sharpen = sharpen;
        settings.current.sharpenAmount = 0.75f;
        settings.current.lumaWeighted = byLuma;
        twin::Inputs inputs = test::mottledFrame(12, 10, 3);
        inputs.jitterPx = {0.3f, -0.2f};
        const PixelStep step = pixelStep(inputs, settings, kPixel);
        // Nine products of about ½, rounded, sharpened with a factor of five at most.
        expectNear(sampled(inputs, step), step.current, 2e-6,
                   parameter("current.filter").choices[filter].id.data());
      }
}

TEST(TwinStep, SamplesAddUpToTheCurrentColorOfEveryKernelThatEnlarges) {
  for (std::size_t kernel = 0; kernel < parameter("current.upsample").choices.size(); ++kernel) {
    Settings settings = test::plainSettings();
    settings.inputs.renderScale = 0.5f;
    settings.current.upsample = static_cast<UpsampleKernel>(kernel);
    twin::Inputs inputs = slope(8, 6);
    inputs.outputPx = {16, 12};
    inputs.jitterPx = {0.25f, -0.125f};
    for (const glm::ivec2& pixel : {glm::ivec2(5, 4), glm::ivec2(8, 7), glm::ivec2(9, 6)}) {
      const PixelStep step = pixelStep(inputs, settings, pixel);
      expectNear(sampled(inputs, step), step.current, 1e-6,
                 parameter("current.upsample").choices[kernel].id.data());
    }
  }
}

// A pixel's center at (2.75, 2.25) of the drawing; the scene there fell on (3, 2.125), so on texel (3, 2),
// whose own center lies at (3.25, 2.625) of the picture at rest.
TEST(TwinStep, SamplesOfASmallerDrawingLieWhereTheyWereTaken) {
  Settings settings = test::plainSettings();
  settings.inputs.renderScale = 0.5f;
  settings.current.upsample = UpsampleKernel::SampleWeight;
  twin::Inputs inputs = slope(8, 6);
  inputs.outputPx = {16, 12};
  inputs.jitterPx = {0.25f, -0.125f};
  const PixelStep step = pixelStep(inputs, settings, {5, 4});
  ASSERT_EQ(step.samples.size(), 1u);
  EXPECT_EQ(step.samples[0].texel, glm::ivec2(3, 2));
  EXPECT_EQ(step.samples[0].offset, glm::dvec2(1.0, 0.75));
}

TEST(TwinStep, ARestartMayBeAMeanOfDiagonals) {
  Settings settings = test::plainSettings();
  settings.blend.restart = Restart::Blurred;
  const twin::Inputs inputs = test::mottledFrame(12, 10, 1);
  const PixelStep step = pixelStep(inputs, settings, kPixel);
  ASSERT_EQ(step.samples.size(), 5u);
  EXPECT_EQ(step.alpha, glm::dvec3(1.0));
  EXPECT_TRUE(step.history.empty());
  expectNear(sampled(inputs, step), step.resolved, 1e-6, "the mean");
}

// α = ½ of 3 against 0: weights of ¼ and 1.
TEST(TwinStep, AlphaIsWhatToneWeightingLeavesOfIt) {
  Settings settings = test::plainSettings();
  settings.weight.alpha = 0.5f;
  settings.blend.tone = ToneWeight::Luma;
  twin::Inputs inputs = test::constantInputs(12, 10, glm::vec3(3.0f));
  test::setHistory(inputs, glm::vec3(0.0f), 4.0f);
  const PixelStep step = pixelStep(inputs, settings, kPixel);
  expectNear(step.alpha, glm::dvec3(0.2), 1e-6, "share");
  expectNear(step.resolved, glm::dvec3(0.6), 1e-6, "color");
}

TEST(TwinStep, EachChannelHasItsAlpha) {
  Settings settings = test::plainSettings();
  settings.weight.source = AlphaSource::ContrastPerChannel;
  settings.blend.tone = ToneWeight::Luma;
  twin::Inputs inputs = test::mottledFrame(12, 10, 1);
  for (int y = 0; y < 10; ++y)
    for (int x = 0; x < 12; ++x) inputs.color.at(x, y)[1] = x % 2 == 0 ? 0.9f : 0.2f;
  test::setHistory(inputs, glm::vec3(0.1f, 0.3f, 0.7f), 4.0f);
  const PixelStep step = pixelStep(inputs, settings, kPixel);
  EXPECT_GT(std::abs(step.alpha.x - step.alpha.y), 0.01);
  const glm::dvec3 history(0.1f, 0.3f, 0.7f);
  expectNear(step.alpha * step.current + (1.0 - step.alpha) * history, step.resolved, 1e-6, "the mix");
}

TEST(TwinStep, TellsWhatItsSampleIsOfFromWhatItFollows) {
  Settings settings = test::plainSettings();
  settings.dilate.method = DilateMethod::Closest3x3;
  twin::Inputs inputs = test::mottledFrame(12, 10, 1);
  for (float& object : inputs.objectId.pixels) object = 3.0f;
  *inputs.objectId.at(kPixel.x, kPixel.y) = 7.0f;
  *inputs.depth.at(kPixel.x + 1, kPixel.y) = 0.2f; // half as far away
  const PixelStep step = pixelStep(inputs, settings, kPixel);
  EXPECT_EQ(step.sampled, 7);
  EXPECT_EQ(step.object, 3);
}

TEST(TwinStep, ReadsNothingBeyondABlackBorder) {
  Settings settings = test::plainSettings();
  twin::Inputs inputs = test::mottledFrame(12, 10, 1);
  test::setMotion(inputs, {0.75f, 0.0f});
  test::setHistory(inputs, glm::vec3(0.5f), 4.0f);
  const auto readOf = [&](HistoryBorder border) {
    settings.history.border = border;
    double sum = 0.0;
    for (const HistoryRead& read : pixelStep(inputs, settings, {0, 5}).history) sum += read.weight;
    return sum;
  };
  EXPECT_EQ(readOf(HistoryBorder::Black), 0.25); // of −0.25: three quarters lie outside
  EXPECT_EQ(readOf(HistoryBorder::Edge), 1.0);
}

TEST(TwinStep, WhatCameNearerIsShownLarger) {
  twin::Inputs inputs = test::mottledFrame(12, 10, 1); // 1 m away
  for (float& depth : inputs.previousDepth.pixels) depth = 2.0f;
  test::setHistory(inputs, glm::vec3(0.5f), 4.0f);
  EXPECT_NEAR(pixelStep(inputs, test::plainSettings(), kPixel).scale, 2.0, 1e-6);
  for (float& depth : inputs.previousDepth.pixels) depth = 0.0f; // the sky, or not known
  EXPECT_EQ(pixelStep(inputs, test::plainSettings(), kPixel).scale, 1.0);
}
