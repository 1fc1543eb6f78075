#include "core/inspect/ShotProfiler.h"

#include "core/base/Say.h"
#include "core/gl/Context.h"
#include "core/replay/ShotPlayer.h"
#include "core/settings/Parameters.h"

#include <cstddef>
#include <span>
#include <string_view>

namespace taa {

ShotProfiler::ShotProfiler(ShotPlayer& player, gl::TimingMethod method)
    : player_(player), method_(method), meter_(method) {}

void ShotProfiler::setProfiling(bool on) {
  if (on == isProfiling()) return;
  timer_.reset();
  profiled_ = 0;
  if (on) timer_.emplace(method_);
}

std::optional<FrameProfile> ShotProfiler::takeProfile() {
  if (!timer_ || timer_->framesStarted() == profiled_) return {};
  profiled_ = timer_->framesStarted();
  std::size_t checkpointBytes = 0;
  for (const Checkpoints& kept : player_.checkpoints()) checkpointBytes += kept.bytes();
  const ShownFrame& shown = player_.shown();
  return profileOf(*timer_, shown.frame, shown.sceneMs + shown.resolveMs, checkpointBytes);
}

StageCosts ShotProfiler::measureStages(const Progress& progress, int lane) {
  const ResolvedFrame frame = player_.resolved(lane);
  if (measured_.lock() != frame.current) {
    measured_ = frame.current;
    pairs_.clear();
    meter_ = PairedMeter(method_);
  }
  StageCosts costs;
  costs.frame = frame.inputs.info.frame;
  costs.width = frame.inputs.outputWidth();
  costs.height = frame.inputs.outputHeight();
  costs.rounds = PairedMeter::kRounds;
  costs.method = method_;
  // The resolves to measure against: first with the cheapest of all stages.
  std::vector<Settings> bases{withCheapest(frame.settings, kCostStages)};
  for (const StageInfo& stage : kCostStages) {
    const Settings base = withCheapest(frame.settings, std::span(&stage, 1));
    costs.stages.push_back({.stage = stage.stage, .ms = {}, .isCheapest = base == frame.settings});
    if (!costs.stages.back().isCheapest) bases.push_back(base);
  }
  while (pairs_.size() < bases.size()) {
    const Progress ofAll = [&](std::string_view, int round, int rounds) {
      return !progress ||
             progress(say<"Measuring stages">(), static_cast<int>(pairs_.size()) * rounds + round,
                      static_cast<int>(bases.size()) * rounds);
    };
    const ResolvedFrame base{frame.inputs, frame.previous, frame.current, bases[pairs_.size()]};
    pairs_.push_back(meter_.measure(player_.maker().pass, frame, base, ofAll));
  }
  costs.whole = measured(pairs_.front().own);
  costs.cheapest = measured(pairs_.front().base);
  auto pair = pairs_.begin();
  for (StageCost& cost : costs.stages)
    if (!cost.isCheapest) cost.ms = timeDifference(*++pair);
  measured_.reset();
  gl::checkErrors(say<"cannot measure the stages">());
  return costs;
}

Measured ShotProfiler::measureRatio(int lane, int base, const Progress& progress) {
  return timeRatio(PairedMeter(method_).measure(player_.maker().pass, player_.resolved(lane),
                                                player_.resolved(base), progress));
}

} // namespace taa
