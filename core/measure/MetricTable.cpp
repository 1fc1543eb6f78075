#include "core/measure/MetricTable.h"

#include "core/base/Error.h"
#include "core/base/Say.h"

#include <algorithm>
#include <string>

namespace taa {

std::optional<Metric> findMetric(std::string_view id) {
  const auto found = std::ranges::find(kMetrics, id, &MetricInfo::id);
  if (found == kMetrics.end()) return {};
  return found->metric;
}

Metric metricNamed(std::string_view id) {
  if (const std::optional<Metric> metric = findMetric(id)) return *metric;
  std::string all;
  for (const MetricInfo& info : kMetrics) all += (all.empty() ? "" : ", ") + std::string(info.id);
  throw Error(say<"no metric is called \"%1\"; there are %2">(id, all));
}

OverTime overTimeOf(Metric metric) {
  const std::optional<IntermediateId> row = findIntermediate(metricInfo(metric).row);
  return row ? overTime(*row) : OverTime::None;
}

std::optional<Metric> metricOfMap(IntermediateId id) {
  if (!isOfReference(id)) return {};
  const auto found = std::ranges::find_if(kMetrics, [id](const MetricInfo& info) {
    return info.category < 0 && info.row == intermediate(id).name;
  });
  if (found == kMetrics.end()) return {};
  return found->metric;
}

} // namespace taa
