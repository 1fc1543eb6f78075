// A still picture accumulates to the mean of its jittered frames (invariants 47, 48).
#include "core/render/ReferencePoints.h"
#include "core/render/passes/SceneRenderer.h"
#include "core/scene/builtin/SceneSource.h"
#include "core/settings/Presets.h"
#include "tests/support/CompareImages.h"
#include "tests/support/GlTest.h"
#include "tests/support/frames/Frames.h"
#include "tests/support/frames/TwinInputs.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace taa {
namespace {

class ConvergenceTest : public test::GlTest {};

constexpr int kWidth = 120;
constexpr int kHeight = 67; // neither a power of two nor even: texel centers are not round numbers

/// Largest |resolved − sum/count|, relative to values above 1.
double largestError(const Image& resolved, const std::vector<double>& sum, double count) {
  double worst = 0.0;
  for (int y = 0; y < resolved.height; ++y) {
    for (int x = 0; x < resolved.width; ++x) {
      for (int channel = 0; channel < 3; ++channel) {
        const double mean = sum[resolved.index(x, y) + static_cast<std::size_t>(channel)] / count;
        const double error = std::fabs(resolved.at(x, y)[channel] - mean) / std::max(1.0, mean);
        if (!(error <= worst)) worst = error; // NaN is the worst
      }
    }
  }
  return worst;
}

void add(std::vector<double>& sum, const Image& image) {
  sum.resize(image.pixels.size());
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += image.pixels[i];
}

TEST_F(ConvergenceTest, AlphaByLengthOnAStillCameraIsTheAverageOfTheJitteredFrames) {
  for (const HistoryFilter filter : {HistoryFilter::Bilinear, HistoryFilter::CatmullRom5}) {
    Settings settings = test::averagingSettings(16);
    settings.history.filter = filter;
    TaaPass pass;
    test::Player player("builtin:fence", "still", kWidth, kHeight, settings);
    std::vector<double> sum;
    Image firstFrame;
    for (int frame = 0; frame < 33; ++frame) {
      player.step(pass);
      const Image color = player.inputs().color.download();
      if (frame == 0) firstFrame = color;
      EXPECT_EQ(test::agree(color, firstFrame), frame % 16 == 0); // the jitter comes round
      add(sum, color);
      EXPECT_LE(largestError(player.history().color.download(), sum, frame + 1), std::ldexp(1.0, -20))
          << "frame " << frame << ", history filter " << static_cast<int>(filter);
    }
    const Image surface = player.history().surface.download();
    EXPECT_NEAR(surface.at(kWidth / 2, kHeight / 2)[0], 33.0f, 1e-4f);
  }
}

TEST_F(ConvergenceTest, AConstantAlphaSettlesToACycleWhoseMeanIsTheAverage) {
  constexpr int kPeriod = 8;
  constexpr float kAlpha = 0.25f;
  Settings settings = test::averagingSettings(kPeriod);
  settings.weight = {AlphaSource::Constant, kAlpha, 0.0f};
  TaaPass pass;
  test::Player player("builtin:fence", "still", kWidth, kHeight, settings);
  constexpr int kSettled = 9 * kPeriod; // 0.75⁷² = 1e-9 is left of the start
  std::vector<double> frames;
  std::vector<double> outputs;
  std::vector<Image> colors;
  for (int frame = 0; frame < kSettled + kPeriod; ++frame) {
    player.step(pass);
    if (frame < kSettled) continue;
    colors.push_back(player.inputs().color.download());
    add(frames, colors.back());
    add(outputs, player.history().color.download());
  }
  // The mean over one period is the arithmetic mean …
  Image mean(kWidth, kHeight, 4);
  for (std::size_t i = 0; i < outputs.size(); ++i) mean.pixels[i] = static_cast<float>(outputs[i] / kPeriod);
  EXPECT_LE(largestError(mean, frames, kPeriod), std::ldexp(1.0, -20));
  // … and each output the weighted sum of the last eight, w_k = α(1−α)^k / (1 − (1−α)^P).
  std::vector<double> weighted(mean.pixels.size());
  for (int k = 0; k < kPeriod; ++k) {
    const double weight = kAlpha * std::pow(1.0 - kAlpha, k) / (1.0 - std::pow(1.0 - kAlpha, kPeriod));
    const Image& color = colors[static_cast<std::size_t>(kPeriod - 1 - k)];
    for (std::size_t i = 0; i < weighted.size(); ++i) weighted[i] += weight * color.pixels[i];
  }
  EXPECT_LE(largestError(player.history().color.download(), weighted, 1.0), std::ldexp(1.0, -20));
  EXPECT_GT(largestError(player.history().color.download(), frames, kPeriod), 1e-3); // not the mean itself
}

/// Root of the mean squared difference to sum/count.
double rmse(const Image& resolved, const std::vector<double>& sum, double count) {
  double squared = 0.0;
  for (std::size_t i = 0; i < sum.size(); ++i)
    if (i % 4 != 3) squared += std::pow(static_cast<double>(resolved.pixels[i]) - sum[i] / count, 2.0);
  return std::sqrt(squared / (0.75 * static_cast<double>(sum.size())));
}

// 64 points of its sequence are even in both directions, 240 are not quite; the error of evenly spread points
// still falls nearly as 1/N, so that a third of the way to 64/240 is asked for. A pattern that repeats after
// 64 frames has the same error at both.
TEST_F(ConvergenceTest, TheReferencePresetComesNearerAfterItsFirst64Frames) {
  constexpr int kSide = 40, kSamples = 1024, kEarly = 64, kLate = 240;
  const Settings settings = preset("reference").settings;
  EXPECT_GE(settings.jitter.period, 4 * kLate);
  TaaPass pass;
  test::Player player("builtin:fence", "still", kSide, kSide, settings);
  SceneRenderer renderer(std::make_shared<const Scene>(openScene("builtin:fence")));
  FrameRequest request;
  request.camera = "still";
  request.width = request.height = kSide;
  request.inputs = settings.inputs;
  std::vector<double> truth;
  FrameInputs sample;
  for (int k = 0; k < kSamples; ++k) {
    request.jitterPx = referencePointPx(k);
    renderer.draw(request, 0, sample);
    add(truth, sample.color.download());
  }
  double early = 0.0;
  for (int frame = 0; frame < kLate; ++frame) {
    player.step(pass);
    if (frame + 1 == kEarly) early = rmse(player.history().color.download(), truth, kSamples);
  }
  const double late = rmse(player.history().color.download(), truth, kSamples);
  EXPECT_GT(early, 1e-3) << "there is something to gain";
  EXPECT_LT(late, 0.75 * early);
}

} // namespace
} // namespace taa
