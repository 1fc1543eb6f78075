#include "app/models/MetricSeries.h"

#include "app/style/Text.h"

#include <cmath>
#include <optional>

namespace taa::app {

bool MetricSeries::setShotVersion(std::uint64_t shotVersion) {
  if (shotVersion == shotVersion_) return false;
  shotVersion_ = shotVersion;
  known_.clear();
  return true;
}

bool MetricSeries::add(const FrameMetrics& metrics) {
  if (metrics.lane != 0 || !metrics.exact || metrics.shotVersion < shotVersion_) return false;
  setShotVersion(metrics.shotVersion);
  // What a delivery leaves out, because nobody asked for it or a reference is missing, stays known.
  FrameMetrics& known = known_[metrics.frame];
  for (std::size_t index = 0; index < metrics.values.size(); ++index)
    if (metrics.values[index]) known.values[index] = metrics.values[index];
  return true;
}

TimelineStrip MetricSeries::strip(Metric metric, int frameCount) const {
  const MetricInfo& info = metricInfo(metric);
  TimelineStrip strip{
      qtext(info.label), info.unit.empty() ? QString() : QLatin1Char(' ') + qtext(info.unit), {}};
  strip.values.resize(static_cast<std::size_t>(frameCount));
  for (const auto& [frame, metrics] : known_) {
    const std::optional<double> value = metrics.at(metric);
    if (frame < frameCount && value && std::isfinite(*value))
      strip.values[static_cast<std::size_t>(frame)] = value;
  }
  return strip;
}

} // namespace taa::app
