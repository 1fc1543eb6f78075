// Does the points of a sweep that nobody has done yet.
#pragma once

#include "core/base/Progress.h"
#include "core/sweep/SweepFolder.h"
#include "core/sweep/SweepPoints.h"
#include "core/sweep/SweepSpec.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace taa {

struct SweepRequest {
  const SweepSpec& spec;
  const SweepFolder& folder;
  SweepShard shard{};
};

/// A point that could not be measured: of a scene that has no such camera, say.
struct SweepFailure {
  std::size_t point = 0;
  std::string reason;
};

/// Points of the shard: `points` is the sum of the others.
struct SweepReport {
  std::size_t points = 0;
  std::size_t kept = 0;     ///< were there
  std::size_t computed = 0; ///< now
  std::vector<SweepFailure> failures;
};

/// The fields of a point's file; throws Error, Cancelled.
using MeasurePoint = std::function<nlohmann::ordered_json(const SweepPoint& point, const Progress& progress)>;

/// In the order of the points. A point that fails does not end the others. Tells `progress` how many points
/// are done and how many of them were there; Cancelled: what was kept stays, what was begun is given up.
/// Throws Cancelled, and Error where the folder cannot be written.
SweepReport runSweep(const SweepRequest& request, const MeasurePoint& measure, const Progress& progress);

} // namespace taa
