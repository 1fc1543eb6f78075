#include "core/capture/import/Comparison.h"

#include "core/base/NumberText.h"
#include "core/base/Say.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace taa::capture {

namespace {

constexpr double kImpossible = std::numeric_limits<double>::infinity();
constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

/// px: hypotheses that lead to places nearer to each other say the same of a pixel.
constexpr float kSamePlace = 0.05f;
constexpr int kRegionColumns = 8, kRegionRows = 6; ///< of regions
constexpr std::size_t kMinPixelsOfRegion = 16;
constexpr std::size_t kRoughStep = 8;

/// Residuals that differ by less are the same but for rounding: 0.00001 of luma.
constexpr double kSameResidual = 0.01;

// The best answer is clear where it wins by this factor, and in this share of the regions that say anything.
constexpr double kClearFactor = 1.05, kClearShare = 0.7;
constexpr std::size_t kClearRegions = 12;

Outcome outcomeOf(FrameSamples& samples, const Trial& trial) {
  Outcome out;
  for (const FramePair& pair : samples.pairs()) {
    const std::optional<PairMotion> motion = samples.motionOf(pair, trial.state, false);
    if (!motion) return {false, {}, {}};
    for (std::size_t i = 0; i < pair.places.size(); ++i) {
      const glm::vec2 moved = trial.isAtRest ? 0.0f * motion->stored[i] : motion->stored[i];
      const glm::vec2 place = glm::vec2(pair.places[i]) + 0.5f - moved + motion->jitterStep;
      const bool isKnown = std::isfinite(place.x) && std::isfinite(place.y);
      out.add(place, isKnown ? std::abs(pair.luma[i] - betweenPixels(pair.previousLuma, place)) : kUnknown);
    }
  }
  return out;
}

/// The region of every pixel of every pair.
std::vector<std::uint32_t> regionsOf(const FrameSamples& samples) {
  std::vector<std::uint32_t> regions;
  const glm::ivec2 size = samples.manifest().sizePx;
  std::uint32_t first = 0;
  for (const FramePair& pair : samples.pairs()) {
    for (const glm::ivec2& place : pair.places)
      regions.push_back(first + static_cast<std::uint32_t>(place.y * kRegionRows / size.y * kRegionColumns +
                                                           place.x * kRegionColumns / size.x));
    first += kRegionColumns * kRegionRows;
  }
  return regions;
}

/// Whether all trials know the pixel and some of them look for it elsewhere than others.
bool tellsApart(const std::vector<Outcome>& outcomes, std::size_t i) {
  glm::vec2 low(std::numeric_limits<float>::max()), high(-std::numeric_limits<float>::max());
  for (const Outcome& outcome : outcomes) {
    if (!outcome.isPossible) continue;
    if (std::isnan(outcome.errors[i])) return false;
    low = glm::min(low, outcome.places[i]);
    high = glm::max(high, outcome.places[i]);
  }
  return std::max(high.x - low.x, high.y - low.y) > kSamePlace;
}

struct RegionSums {
  double best = 0.0, second = 0.0;
  std::size_t pixels = 0;
};

void compareRegions(const Outcome& best, const Outcome& second, const std::vector<std::size_t>& pixels,
                    const std::vector<std::uint32_t>& regions, TrialComparison& out) {
  std::vector<RegionSums> sums(regions.empty() ? 0 : regions.back() + kRegionColumns * kRegionRows);
  for (const std::size_t i : pixels) {
    if (glm::distance(best.places[i], second.places[i]) <= kSamePlace) continue;
    RegionSums& sum = sums[regions[i]];
    sum.best += static_cast<double>(best.errors[i]);
    sum.second += static_cast<double>(second.errors[i]);
    ++sum.pixels;
    ++out.told;
  }
  std::size_t won = 0;
  for (const RegionSums& sum : sums) {
    if (sum.pixels < kMinPixelsOfRegion || sum.best == sum.second) continue;
    ++out.regions;
    if (sum.best < sum.second) ++won;
  }
  if (out.regions > 0) out.share = static_cast<double>(won) / static_cast<double>(out.regions);
}

} // namespace

bool TrialComparison::hasRegions() const {
  return regions >= kClearRegions;
}

bool TrialComparison::isClear() const {
  return gain >= kSameResidual && factor >= kClearFactor && share >= kClearShare && hasRegions();
}

bool TrialComparison::isEven() const {
  return possible > 1 && (gain < kSameResidual || factor < kClearFactor || !hasRegions());
}

TrialComparison compare(FrameSamples& samples, const std::vector<Trial>& trials) {
  std::vector<Outcome> outcomes;
  for (const Trial& trial : trials) outcomes.push_back(outcomeOf(samples, trial));
  return compare(samples, outcomes);
}

TrialComparison compare(const FrameSamples& samples, const std::vector<Outcome>& outcomes) {
  TrialComparison out;
  out.residuals.assign(outcomes.size(), kImpossible);
  const std::vector<std::uint32_t> regions = regionsOf(samples);
  std::vector<std::size_t> pixels;
  for (std::size_t i = 0; i < regions.size(); ++i)
    if (tellsApart(outcomes, i)) pixels.push_back(i);
  out.pixels = pixels.size();
  std::vector<std::size_t> order;
  for (std::size_t trial = 0; trial < outcomes.size(); ++trial) {
    if (!outcomes[trial].isPossible) continue;
    double sum = 0.0;
    for (const std::size_t i : pixels) sum += static_cast<double>(outcomes[trial].errors[i]);
    out.residuals[trial] = pixels.empty() ? 0.0 : 1000.0 * sum / static_cast<double>(pixels.size());
    order.push_back(trial);
  }
  std::ranges::stable_sort(order, {}, [&](std::size_t trial) { return out.residuals[trial]; });
  out.possible = order.size();
  if (order.empty()) return out;
  out.best = order[0];
  if (order.size() < 2) return out;
  out.gain = out.residuals[order[1]] - out.residuals[order[0]];
  out.factor = out.residuals[order[1]] / std::max(out.residuals[order[0]], 1e-9);
  compareRegions(outcomes[order[0]], outcomes[order[1]], pixels, regions, out);
  return out;
}

TrialComparison compare(FrameSamples& samples, const TestState& first, const TestState& second) {
  return compare(samples, {{"", {}, first}, {"", {}, second}});
}

bool isClearlyLess(FrameSamples& samples, const TestState& one, const TestState& other) {
  const TrialComparison comparison = compare(samples, other, one);
  return comparison.best == 1 && comparison.isClear();
}

double roughResidual(FrameSamples& samples, const TestState& state) {
  return roughResidual(samples, samples.pairs(), state);
}

double roughResidual(FrameSamples& samples, std::span<const FramePair> pairs, const TestState& state) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const FramePair& pair : pairs) {
    const std::optional<PairMotion> motion = samples.motionOf(pair, state, false);
    if (!motion) return kImpossible;
    for (std::size_t i = 0; i < pair.places.size(); i += kRoughStep) {
      const glm::vec2 place = glm::vec2(pair.places[i]) + 0.5f - motion->stored[i] + motion->jitterStep;
      if (!std::isfinite(place.x) || !std::isfinite(place.y)) continue;
      sum += static_cast<double>(std::abs(pair.luma[i] - betweenPixels(pair.previousLuma, place)));
      ++count;
    }
  }
  return count == 0 ? kImpossible : 1000.0 * sum / static_cast<double>(count);
}

std::string reasonOf(const TrialComparison& comparison) {
  if (comparison.possible < 2)
    return comparison.possible == 0 ? say<"no answer agrees with the matrices">()
                                    : say<"the other answers do not agree with the matrices">();
  if (comparison.told == 0 && comparison.pixels > 0)
    return say<"the best two answers say the same of these frames">();
  if (!comparison.hasRegions())
    return say<"too little moves to tell: the best two answers differ at %1 pixels">(comparison.told);
  if (comparison.gain < kSameResidual)
    return say<"the pictures have too little detail to tell: the best two answers leave the same">();
  const int percent = static_cast<int>(std::lround(100.0 * comparison.share));
  const std::string factor = roundedText(std::min(comparison.factor, 1e6), 2);
  if (comparison.isClear())
    return say<"the next one leaves %1 times as much, and more in %2 % of %3 regions">(factor, percent,
                                                                                       comparison.regions);
  if (comparison.factor < kClearFactor)
    return say<"the next one leaves only %1 times as much, and more in %2 % of %3 regions">(
        factor, percent, comparison.regions);
  return say<"the next one leaves %1 times as much, and more in only %2 % of %3 regions">(factor, percent,
                                                                                          comparison.regions);
}

} // namespace taa::capture
