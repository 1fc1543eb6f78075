#include "core/probe/SampleWeights.h"

#include "core/render/Jitter.h"
#include "core/taa/twin/BlendStages.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace taa {

namespace {

/// A gray pixel that stays as it is, near the camera.
twin::WeightInputs pixelAtRest(const Settings& settings, int frame) {
  constexpr float kGray = 0.5f;
  twin::WeightInputs weighed;
  weighed.hasHistory = frame > 0;
  weighed.lumaCurrent = weighed.lumaHistory = kGray;
  weighed.boxCurrent = weighed.boxHistoryRaw = weighed.boxHistory = weighed.boxLow = weighed.boxHigh = kGray;
  weighed.compressedCurrent = weighed.compressedHistory = kGray / (1.0f + kGray);
  weighed.maxCurrent = weighed.maxHistory = kGray / (1.0f + kGray);
  weighed.depth = 1.0f;
  weighed.jitterPx =
      jitterPx(settings.jitter, frame); // its length alone matters, whatever way the camera moves
  return weighed;
}

} // namespace

std::vector<double> frameWeights(std::span<const double> alphas) {
  std::vector<double> weights(alphas.size());
  double kept = 1.0;
  for (std::size_t index = alphas.size(); index-- > 0;) {
    weights[index] = kept * alphas[index];
    kept *= 1.0 - alphas[index];
  }
  return weights;
}

double effectiveSamples(std::span<const double> weights) {
  double sum = 0.0, squares = 0.0;
  for (const double weight : weights) {
    sum += weight;
    squares += weight * weight;
  }
  return squares > 0.0 ? sum * sum / squares : 0.0;
}

std::vector<double> effectiveSamplesOver(std::span<const double> alphas) {
  std::vector<double> counts;
  counts.reserve(alphas.size());
  double sum = 0.0, squares = 0.0;
  for (const double alpha : alphas) {
    sum = alpha + (1.0 - alpha) * sum;
    squares = alpha * alpha + (1.0 - alpha) * (1.0 - alpha) * squares;
    counts.push_back(squares > 0.0 ? sum * sum / squares : 0.0);
  }
  return counts;
}

std::vector<double> alphasAtRest(const Settings& settings, int frames) {
  std::vector<double> alphas;
  float length = 0.0f;
  for (int frame = 0; frame < frames; ++frame) {
    const twin::WeightInputs weighed = pixelAtRest(settings, frame);
    const twin::Weights weights = twin::blendWeight(settings, length, frame == 0 ? 1.0f : 0.0f, weighed);
    twin::BlendInputs mix;
    mix.current = mix.history = glm::vec3(weighed.lumaCurrent);
    mix.alpha = weights.alpha;
    mix.channels = weights.channels;
    mix.historyLength = length;
    mix.frame = frame;
    mix.isFirst = frame == 0;
    length = twin::blend(settings, mix).historyLength;
    alphas.push_back(static_cast<double>(weights.alpha));
  }
  return alphas;
}

JitterPattern jitterPattern(const JitterSettings& settings, int frame, std::span<const double> weights,
                            const glm::dvec2& way) {
  std::vector<glm::vec2> points;
  for (int index = 0; index < jitterPeriod(settings); ++index)
    points.push_back(jitterPx(settings, index, way));
  return jitterPattern(points, frame, weights);
}

JitterPattern jitterPattern(std::span<const glm::vec2> pointsPx, int frame, std::span<const double> weights) {
  assert(!pointsPx.empty());
  JitterPattern pattern;
  const int period = static_cast<int>(pointsPx.size());
  pattern.samples.resize(pointsPx.size());
  // Content is moved by the jitter, so the sample at the pixel's center shows what lies the other way.
  for (std::size_t index = 0; index < pointsPx.size(); ++index)
    pattern.samples[index].position = 0.5 - glm::dvec2(pointsPx[index]);
  for (std::size_t age = 0; age < weights.size() && static_cast<int>(age) <= frame; ++age) {
    const int index = (frame - static_cast<int>(age)) % period;
    pattern.samples[static_cast<std::size_t>(index)].weight += weights[weights.size() - 1 - age];
  }
  pattern.cells = std::max(1, static_cast<int>(std::floor(std::sqrt(static_cast<double>(period)))));
  std::vector<bool> isHit(static_cast<std::size_t>(pattern.cells) * pattern.cells);
  double sum = 0.0;
  std::vector<double> places;
  for (const JitterSample& sample : pattern.samples) {
    pattern.mean += (sample.position - 0.5) / static_cast<double>(period);
    pattern.weightedMean += sample.weight * (sample.position - 0.5);
    sum += sample.weight;
    places.push_back(sample.weight);
    const glm::ivec2 cell = glm::clamp(glm::ivec2(glm::floor(sample.position * double(pattern.cells))),
                                       glm::ivec2(0), glm::ivec2(pattern.cells - 1));
    isHit[static_cast<std::size_t>(cell.y) * pattern.cells + cell.x] = true;
  }
  if (sum > 0.0) pattern.weightedMean /= sum;
  pattern.coverage = static_cast<double>(std::ranges::count(isHit, true)) / static_cast<double>(isHit.size());
  pattern.effective = effectiveSamples(places);
  return pattern;
}

} // namespace taa
