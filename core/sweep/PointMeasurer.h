// Measures points of a sweep, one after the other, on what the one before left open.
#pragma once

#include "core/base/Progress.h"
#include "core/scene/SceneCost.h"
#include "core/sweep/SweepPoints.h"
#include "core/sweep/SweepSpec.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

namespace taa {

class Inspector;

/// Lives on one thread; opens nothing, and no GL context, before the first point.
class PointMeasurer {
 public:
  /// `spec` must outlive it; `budget`: of each of its scenes.
  explicit PointMeasurer(const SweepSpec& spec, const SceneBudget& budget = {});
  ~PointMeasurer();
  PointMeasurer(const PointMeasurer&) = delete;
  PointMeasurer& operator=(const PointMeasurer&) = delete;

  /// {"driver", "frames": [{"frame", metric: …}, …], "mean": {metric: …}}. The same numbers whatever was
  /// measured before. Throws Error where the source has no such frame, camera or size; Cancelled.
  nlohmann::ordered_json measure(const SweepPoint& point, const Progress& progress);

 private:
  void open(const SweepPoint& point, const Progress& progress);

  const SweepSpec& spec_;
  SceneBudget budget_;
  std::unique_ptr<Inspector> inspector_;
  std::optional<std::pair<std::size_t, std::size_t>> shot_; ///< source and camera that are open
};

} // namespace taa
