#include "core/measure/ResolveRatio.h"

#include "core/base/Say.h"
#include "core/measure/StageCosts.h"
#include "core/replay/Checkpoints.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace taa {

namespace {

constexpr int kRatioRounds = 15; // so that the range leaves out three of them at each end
constexpr double kMinRatioSampleMs = 4.0;
constexpr int kMaxRatioRepeats = 64;

double resolveMs(TaaPass& pass, const ResolvedFrame& frame, History& target, gl::TimingMethod method,
                 int repeats) {
  gl::PassTimer timer(method);
  for (int draw = 0; draw < repeats; ++draw)
    pass.resolve(frame.inputs, frame.previous.get(), frame.settings, target);
  double sum = 0.0;
  for (const gl::PassTime& each : timer.take()) sum += each.milliseconds;
  return sum / repeats;
}

} // namespace

CostRatio costRatio(std::span<const double> times, std::span<const double> baseTimes) {
  assert(times.size() == baseTimes.size() && times.size() >= 6);
  std::vector<double> ratios;
  for (std::size_t round = 0; round < times.size(); ++round)
    ratios.push_back(times[round] / std::max(baseTimes[round], 1e-6));
  const MeasuredMs all = measured(std::move(ratios));
  return {all.median, all.low, all.high};
}

CostRatio measureCostRatio(TaaPass& pass, const ResolvedFrame& frame, const ResolvedFrame& base,
                           gl::TimingMethod method, const Progress& progress) {
  const std::array<const ResolvedFrame*, 2> frames{&frame, &base};
  std::array<History, 2> targets;
  std::array<std::vector<double>, 2> times;
  // Compiles, and says how often to draw: a GPU is done before its clock ticks.
  double fastest = kMinRatioSampleMs;
  for (std::size_t side = 0; side < frames.size(); ++side) {
    resolveMs(pass, *frames[side], targets[side], method, 1);
    fastest = std::min(fastest, resolveMs(pass, *frames[side], targets[side], method, 1));
  }
  const int repeats = std::clamp(static_cast<int>(std::ceil(kMinRatioSampleMs / std::max(fastest, 1e-3))), 1,
                                 kMaxRatioRepeats);
  for (int round = 0; round < kRatioRounds; ++round) {
    report(progress, say<"Timing the resolve">(), round, kRatioRounds);
    for (std::size_t place = 0; place < frames.size(); ++place) {
      const std::size_t side = round % 2 == 0 ? place : 1 - place;
      times[side].push_back(resolveMs(pass, *frames[side], targets[side], method, repeats));
    }
  }
  return costRatio(times[0], times[1]);
}

} // namespace taa
