#include "core/sweep/MetricsOfFrames.h"

#include "core/base/FreeMemory.h"
#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/inspect/Inspector.h"
#include "core/render/CaptureFacts.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace taa {

using nlohmann::ordered_json;

std::vector<Metric> metricsThere(int referenceSamples, const std::vector<OverTime>& kinds) {
  std::vector<Metric> there;
  for (const MetricInfo& info : kMetrics)
    if (!info.isCostly && (referenceSamples > 0 || !info.needsReference) &&
        (!info.isOverTime || std::ranges::count(kinds, overTimeOf(info.metric)) > 0))
      there.push_back(info.metric);
  return there;
}

void requireMeasurable(const Inspector& inspector, int referenceSamples) {
  if (const auto captured = inspector.shot().capture();
      captured && !captured->hasReference && referenceSamples > 0)
    throw Error(whyNoReference());
}

void keepReferences(Inspector& inspector, const MetricsRequest& request) {
  const auto frames = static_cast<std::size_t>(request.last - request.first + inspector.overTime().frames());
  const auto pixels = static_cast<std::size_t>(inspector.shot().width()) *
                      static_cast<std::size_t>(inspector.shot().height());
  const std::size_t wanted = frames * pixels * 3 * sizeof(double);
  const std::size_t most = std::max(kReferenceBudget, freeMemory().value_or(0) / 2);
  inspector.reference().setBudget(std::clamp(wanted, kReferenceBudget, most));
}

std::vector<LaneMetrics> measureFrames(Inspector& inspector, const MetricsRequest& request,
                                       const Progress& progress,
                                       const std::function<void(int frame)>& begun) {
  const int samples = request.referenceSamples;
  std::vector<OverTime> kinds;
  for (const OverTime kind : {OverTime::Flicker, OverTime::Parts})
    if (std::ranges::count(request.wanted, kind, overTimeOf) > 0) kinds.push_back(kind);
  const bool isCompared = std::ranges::any_of(request.wanted, [](Metric metric) {
    return metricInfo(metric).needsReference && !metricInfo(metric).isOverTime;
  });
  std::vector<LaneMetrics> lanes(static_cast<std::size_t>(inspector.shot().laneCount()));
  for (int frame = request.first; frame <= request.last; ++frame) {
    if (begun) begun(frame);
    report(progress, say<"Measuring frames">(), frame - request.first, request.last - request.first + 1);
    inspector.shot().seek(frame, frame == request.first ? progress : Progress());
    for (int lane = 0; lane < inspector.shot().laneCount(); ++lane) {
      if (samples > 0 && isCompared) inspector.reference().refine(samples, progress, lane);
      inspector.overTime().refine(kinds, samples, progress, lane);
      lanes[static_cast<std::size_t>(lane)].push_back(inspector.metrics().measure(request.wanted, lane));
    }
  }
  return lanes;
}

std::optional<double> meanOfFrames(const LaneMetrics& lane, Metric metric) {
  double sum = 0.0;
  int count = 0;
  for (const FrameMetrics& frame : lane) {
    sum += frame.at(metric).value_or(0.0);
    count += frame.at(metric) ? 1 : 0;
  }
  if (count == 0) return {};
  return sum / count;
}

std::string metricHeading(Metric metric) {
  const MetricInfo& info = metricInfo(metric);
  return std::string(info.id) + (info.unit.empty() ? "" : " (" + std::string(info.unit) + ")");
}

std::string exactMetricText(const std::optional<double>& value) {
  if (!value) return "";
  return shortestText(*value);
}

std::string shortMetricText(const std::optional<double>& value) {
  return value ? significantText(*value, 5) : "-";
}

ordered_json metricJson(const std::optional<double>& value) {
  if (!value) return nullptr;
  return std::isfinite(*value) ? ordered_json(*value) : ordered_json(exactMetricText(value));
}

ordered_json metricsJson(const std::vector<Metric>& metrics) {
  ordered_json list = ordered_json::array();
  for (const Metric metric : metrics) {
    const MetricInfo& info = metricInfo(metric);
    list.push_back({{"id", info.id}, {"unit", info.unit}, {"description", info.description}});
  }
  return list;
}

ordered_json framesJson(const LaneMetrics& lane, const std::vector<Metric>& metrics) {
  ordered_json rows;
  for (const FrameMetrics& frame : lane) {
    ordered_json row = {{"frame", frame.frame}};
    for (const Metric metric : metrics)
      row[std::string(metricInfo(metric).id)] = metricJson(frame.at(metric));
    rows.push_back(row);
  }
  return rows;
}

ordered_json meansJson(const LaneMetrics& lane, const std::vector<Metric>& metrics) {
  ordered_json means;
  for (const Metric metric : metrics)
    means[std::string(metricInfo(metric).id)] = metricJson(meanOfFrames(lane, metric));
  return means;
}

} // namespace taa
