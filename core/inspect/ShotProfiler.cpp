#include "core/inspect/ShotProfiler.h"

#include "core/replay/ShotPlayer.h"

#include <cstddef>

namespace taa {

ShotProfiler::ShotProfiler(ShotPlayer& player, gl::TimingMethod method)
    : player_(player), method_(method), stages_(method) {}

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
  return stages_.measure(player_.maker().pass, player_.resolved(lane), progress);
}

CostRatio ShotProfiler::measureRatio(int lane, int base, const Progress& progress) {
  return measureCostRatio(player_.maker().pass, player_.resolved(lane), player_.resolved(base), method_,
                          progress);
}

} // namespace taa
