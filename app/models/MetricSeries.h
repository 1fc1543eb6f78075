// A metric of each frame of the shot, as far as it was measured, as long as it is true.
#pragma once

#include "app/models/TimelineStrip.h"
#include "core/measure/Metrics.h"

#include <cstdint>
#include <map>

namespace taa::app {

class MetricSeries {
 public:
  /// Drops all that is known when frames are a function of something else now (Status::shotVersion); true: so
  /// it was.
  bool setShotVersion(std::uint64_t shotVersion);
  /// Takes what is exact, of the first lane; false: nothing of it.
  bool add(const FrameMetrics& metrics);
  TimelineStrip strip(Metric metric, int frameCount) const;

 private:
  std::uint64_t shotVersion_ = 0;
  std::map<int, FrameMetrics> known_;
};

} // namespace taa::app
