// A search for better settings on a shot that somebody looks at, beside it.
#pragma once

#include "core/base/Progress.h"
#include "core/io/SessionFile.h"
#include "core/sweep/tune/Tuning.h"

#include <functional>

namespace taa {

struct ShotTuneRequest {
  SessionFile shot; ///< all but its settings and lanes
  Settings start;   ///< where the search begins
  TuneRequest tuning{};
};

/// How far it has come: after each evaluation, and at the end.
using TuneTold = std::function<void(const TuneWay& way)>;

/// With an Inspector of its own: expects a thread that has none. The same way as `taa-batch tune` goes.
/// Throws Error, Cancelled; what was found until then stays told.
void tuneShot(const ShotTuneRequest& request, const TuneTold& told, const Progress& progress);

} // namespace taa
