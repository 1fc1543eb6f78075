// Settings measured one after the other on a shot that somebody looks at, and on others, beside it.
#pragma once

#include "core/base/Progress.h"
#include "core/io/SessionFile.h"
#include "core/sweep/MetricsOfFrames.h"
#include "core/sweep/SweepSpec.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace taa {

struct ShotSweepRequest {
  std::vector<SessionFile> shots;      ///< all of them but their settings and lanes
  std::vector<SweepSettings> settings; ///< that are measured on each of them
  MetricsRequest metrics{};
  /// Also Metric::Supersampling, of the first settings on each shot: it is that of all.
  bool hasSupersampling = false;

  /// Shots slowest.
  std::size_t count() const { return shots.size() * settings.size(); }
  const SessionFile& shotOf(std::size_t index) const { return shots[index / settings.size()]; }
  const SweepSettings& settingsOf(std::size_t index) const { return settings[index % settings.size()]; }
};

/// The metrics of every frame of `settingsOf(index)` on `shotOf(index)`, as soon as they are known.
using SettingsMeasured = std::function<void(std::size_t index, const LaneMetrics& frames)>;

/// With an Inspector of its own: expects a thread that has none. The same numbers as `taa-batch metrics` has.
/// Reports frame by frame over all settings on all shots. Throws Error, also where a shot has no such frames,
/// and Cancelled; what was measured stays told.
void sweepShots(const ShotSweepRequest& request, const SettingsMeasured& measured, const Progress& progress);

} // namespace taa
