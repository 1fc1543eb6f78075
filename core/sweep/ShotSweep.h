// Settings measured one after the other on a shot that somebody looks at, beside it.
#pragma once

#include "core/base/Progress.h"
#include "core/io/SessionFile.h"
#include "core/sweep/MetricsOfFrames.h"
#include "core/sweep/SweepSpec.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace taa {

class Inspector;

struct ShotSweepRequest {
  SessionFile shot;                    ///< all but its settings and lanes
  std::vector<SweepSettings> settings; ///< that are measured
  MetricsRequest metrics{};
};

/// The metrics of every frame of `settings[index]`, as soon as they are known.
using SettingsMeasured = std::function<void(std::size_t index, const LaneMetrics& frames)>;

/// Opens what `shot` says, but for its settings and lanes. Throws Error, Cancelled.
void openShotOf(Inspector& inspector, const SessionFile& shot, const Progress& progress);

/// With an Inspector of its own: expects a thread that has none. The same numbers as `taa-batch metrics` has.
/// Reports frame by frame over all settings. Throws Error, Cancelled; what was measured stays told.
void sweepShot(const ShotSweepRequest& request, const SettingsMeasured& measured, const Progress& progress);

} // namespace taa
