// How much frames count in an accumulated pixel: the manual's numbers, and patterns whose figures are
// known.
#include "core/probe/SampleWeights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

using namespace taa;

namespace {

std::vector<double> constantAlphas(double alpha, std::size_t frames) {
  std::vector<double> alphas(frames, alpha);
  alphas[0] = 1.0;
  return alphas;
}

} // namespace

TEST(SampleWeights, DecayByOneMinusAlphaAFrame) {
  const std::vector<double> weights = frameWeights(std::vector{1.0, 0.5, 0.25, 0.5});
  EXPECT_EQ(weights, (std::vector{0.1875, 0.1875, 0.125, 0.5}));
  const std::vector<double> constant = frameWeights(constantAlphas(0.1, 60));
  for (std::size_t age = 0; age + 1 < constant.size(); ++age)
    EXPECT_NEAR(constant[constant.size() - 1 - age], 0.1 * std::pow(0.9, static_cast<double>(age)), 1e-15);
  EXPECT_NEAR(std::accumulate(constant.begin(), constant.end(), 0.0), 1.0, 1e-14);
}

TEST(SampleWeights, AreEqualUnderARunningMean) {
  std::vector<double> alphas;
  for (int frame = 0; frame < 8; ++frame) alphas.push_back(1.0 / (frame + 1));
  for (const double weight : frameWeights(alphas)) EXPECT_NEAR(weight, 0.125, 1e-15);
  EXPECT_NEAR(effectiveSamples(frameWeights(alphas)), 8.0, 1e-12);
}

TEST(SampleWeights, CountTheSamplesThatTheCatalogueGives) {
  // Manual source 000, α = 0.1: 2.17 after 5 frames, 5.13 after 10, 9.78 after 15, 19 at last.
  const std::vector<double> counts = effectiveSamplesOver(constantAlphas(0.1, 400));
  EXPECT_NEAR(counts[4], 2.17, 0.005);
  EXPECT_NEAR(counts[9], 5.13, 0.005);
  EXPECT_NEAR(counts[14], 9.78, 0.005);
  EXPECT_NEAR(counts[399], 19.0, 1e-9);
  EXPECT_EQ(counts[0], 1.0);
  for (std::size_t frames : {1u, 7u, 40u})
    EXPECT_NEAR(counts[frames - 1], effectiveSamples(frameWeights(constantAlphas(0.1, frames))), 1e-12);
  EXPECT_EQ(effectiveSamples({}), 0.0);
}

TEST(SampleWeights, OfACalmPixelAreWhatTheSettingsSay) {
  Settings settings;
  settings.weight = {};
  settings.weight.source = AlphaSource::Constant;
  settings.weight.alpha = 0.125f;
  settings.weight.minimum = 0.0f;
  EXPECT_EQ(alphasAtRest(settings, 4), (std::vector{1.0, 0.125, 0.125, 0.125}));
  settings.weight.source = AlphaSource::HistoryLength;
  settings.blend.length = LengthRule::Count;
  EXPECT_EQ(alphasAtRest(settings, 4), (std::vector<double>{1.0, 0.5, 1.0f / 3.0f, 0.25}));
  settings.weight.minimum = 0.5f;
  EXPECT_EQ(alphasAtRest(settings, 4), (std::vector{1.0, 0.5, 0.5, 0.5}));
}

TEST(JitterPattern, PutsSamplesWhereTheyLieAndSumsTheirWeights) {
  JitterSettings settings;
  settings.sequence = JitterSequence::Uniform2; // two places on the diagonal
  const JitterPattern pattern = jitterPattern(settings, 3, std::vector{0.125, 0.125, 0.25, 0.5});
  ASSERT_EQ(pattern.samples.size(), 2u);
  EXPECT_EQ(pattern.samples[0].weight, 0.125 + 0.25);
  EXPECT_EQ(pattern.samples[1].weight, 0.125 + 0.5);
  EXPECT_EQ(pattern.samples[0].position + pattern.samples[1].position, glm::dvec2(1.0)) << "symmetric";
  EXPECT_EQ(pattern.mean, glm::dvec2(0.0));
  EXPECT_EQ(pattern.weightedMean, 0.25 * (pattern.samples[1].position - 0.5));
  EXPECT_NEAR(pattern.effective, 1.0 / (0.375 * 0.375 + 0.625 * 0.625), 1e-15);
}

TEST(JitterPattern, MeasuresHowMuchOfThePixelIsCovered) {
  JitterSettings settings;
  settings.sequence = JitterSequence::Halton;
  settings.period = 16;
  const JitterPattern halton = jitterPattern(settings, 0, std::vector{1.0});
  EXPECT_EQ(halton.cells, 4);
  EXPECT_GE(halton.coverage, 0.75);
  EXPECT_EQ(halton.effective, 1.0);
  settings.scale = 0.0f; // all at the center
  EXPECT_EQ(jitterPattern(settings, 0, {}).coverage, 1.0 / 16.0);
  settings.sequence = JitterSequence::None;
  settings.period = 1;
  EXPECT_EQ(jitterPattern(settings, 7, std::vector{1.0}).coverage, 1.0);
}
