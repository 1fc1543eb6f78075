#include "core/measure/StageCosts.h"

#include "core/base/Median.h"
#include "core/base/NumberText.h"
#include "core/base/Say.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace taa {

namespace {

// The chance that the true median lies outside the range from the k-th smallest value to the k-th largest is
// that of fewer than k of n coins falling on one side, twice.
constexpr double kChanceOutside = 0.04;

/// The largest such k; 0: there are too few.
std::size_t rankOfRange(std::size_t count) {
  double coins = std::pow(0.5, static_cast<double>(count)); // exactly 0 of them
  double outside = 0.0;
  std::size_t rank = 0;
  for (; rank < count / 2; ++rank) {
    outside += 2.0 * coins;
    if (outside > kChanceOutside) break;
    coins *= static_cast<double>(count - rank) / static_cast<double>(rank + 1);
  }
  return rank;
}

} // namespace

double MeasuredMs::spread() const {
  return std::max(high - median, median - low);
}

MeasuredMs measured(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t rank = rankOfRange(values.size());
  if (rank == 0) {
    constexpr double kAnything = std::numeric_limits<double>::infinity();
    return {median(values), -kAnything, kAnything};
  }
  return {median(values), values[rank - 1], values[values.size() - rank]};
}

CostVerdict StageCost::verdict() const {
  if (ms.median > ms.spread()) return CostVerdict::Clear;
  return ms.median < -ms.spread() ? CostVerdict::Negative : CostVerdict::Noise;
}

std::string verdictWords(const StageCost& cost) {
  switch (cost.verdict()) {
  case CostVerdict::Clear:
    break;
  case CostVerdict::Noise:
    return say<"not above the noise, ± %1 ms">(fixedText(cost.ms.spread(), 3));
  case CostVerdict::Negative:
    return say<"below 0: the compiler leaves out of the longer program what the shorter one has to keep">();
  }
  return {};
}

std::vector<StageCost> stageCosts(std::span<const Stage> stages, std::span<const RoundTimes> times) {
  assert(times.size() == stages.size() + 1);
  std::vector<StageCost> costs;
  for (std::size_t stage = 0; stage < stages.size(); ++stage) {
    const RoundTimes &without = times[stage], &with = times[stage + 1];
    assert(without.size() == with.size());
    std::vector<double> differences;
    for (std::size_t round = 0; round < with.size(); ++round)
      differences.push_back(with[round] - without[round]);
    costs.push_back({stages[stage], measured(std::move(differences))});
  }
  return costs;
}

} // namespace taa
