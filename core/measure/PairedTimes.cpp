#include "core/measure/PairedTimes.h"

#include "core/base/Median.h"
#include "core/base/Say.h"
#include "core/replay/Checkpoints.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>

namespace taa {

namespace {

constexpr double kMinSampleMs = 4.0;
constexpr int kMaxRepeats = 64;

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

template <typename Compare>
Measured ofRounds(const PairedTimes& times, Compare compare) {
  assert(times.own.size() == times.base.size());
  std::vector<double> values;
  std::ranges::transform(times.own, times.base, std::back_inserter(values), compare);
  return measured(std::move(values));
}

} // namespace

double Measured::spread() const {
  return std::max(high - median, median - low);
}

Measured measured(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t rank = rankOfRange(values.size());
  if (rank == 0) {
    constexpr double kAnything = std::numeric_limits<double>::infinity();
    return {median(values), -kAnything, kAnything};
  }
  return {median(values), values[rank - 1], values[values.size() - rank]};
}

Measured timeDifference(const PairedTimes& times) {
  return ofRounds(times, [](double own, double base) { return own - base; });
}

Measured timeRatio(const PairedTimes& times) {
  return ofRounds(times, [](double own, double base) { return own / std::max(base, 1e-6); });
}

double knownRatio(const Measured& ratio) {
  return ratio.low <= 1.0 && ratio.high >= 1.0 ? 1.0 : ratio.median;
}

PairedTimes PairedMeter::measure(TaaPass& pass, const ResolvedFrame& own, const ResolvedFrame& base,
                                 const Progress& progress) {
  const auto milliseconds = [&](bool isOwn, int repeats) {
    const ResolvedFrame& frame = isOwn ? own : base;
    gl::PassTimer timer(method_);
    for (int draw = 0; draw < repeats; ++draw)
      pass.resolve(frame.inputs, frame.previous.get(), frame.settings, targets_[isOwn ? 0 : 1]);
    double sum = 0.0;
    for (const gl::PassTime& each : timer.take()) sum += each.milliseconds;
    return sum / repeats;
  };
  for (int round = static_cast<int>(times_.own.size()); round < kRounds; ++round) {
    report(progress, say<"Timing the resolve">(), round, kRounds);
    if (round == 0) {
      milliseconds(true, 1); // compiles
      milliseconds(false, 1);
      const double faster = std::min(milliseconds(true, 1), milliseconds(false, 1));
      repeats_ =
          std::clamp(static_cast<int>(std::ceil(kMinSampleMs / std::max(faster, 1e-3))), 1, kMaxRepeats);
    }
    const bool ownFirst = round % 2 == 0;
    const double first = milliseconds(ownFirst, repeats_), second = milliseconds(!ownFirst, repeats_);
    times_.own.push_back(ownFirst ? first : second);
    times_.base.push_back(ownFirst ? second : first);
  }
  targets_ = {};
  return std::exchange(times_, {});
}

} // namespace taa
