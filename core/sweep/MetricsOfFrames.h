// Metrics of a range of frames, and their texts: what `taa-batch metrics` prints and a point of a sweep
// holds.
#pragma once

#include "core/base/Progress.h"
#include "core/measure/Metrics.h"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace taa {

class Inspector;

/// Of one lane, frame by frame.
using LaneMetrics = std::vector<FrameMetrics>;

struct MetricsRequest {
  int first = 0, last = 0; ///< frames, both included
  std::vector<Metric> wanted;
  int referenceSamples = kReferenceSamples; ///< 0: nothing is compared with a reference
};

/// All of them that are not costly, but without samples those that need none, and over time only what of
/// `kinds` is measured.
std::vector<Metric> metricsThere(int referenceSamples, const std::vector<OverTime>& kinds);

/// Throws Error where a captured sequence without a reference of its own would be compared with one.
void requireMeasurable(const Inspector& inspector, int referenceSamples);

/// Has the references of all these frames kept, as far as half of the free memory goes: whoever measures the
/// same frames with other settings draws none of them again.
void keepReferences(Inspector& inspector, const MetricsRequest& request);

/// Of each lane of what is open; ends at the last frame. `begun` hears of each frame before it is measured.
/// Throws Error, Cancelled.
std::vector<LaneMetrics> measureFrames(Inspector& inspector, const MetricsRequest& request,
                                       const Progress& progress,
                                       const std::function<void(int frame)>& begun = {});

/// Of the frames that have it: nothing changes over time up to the first, or to a cut.
std::optional<double> meanOfFrames(const LaneMetrics& lane, Metric metric);

/// "psnr (dB)"
std::string metricHeading(Metric metric);
/// As few digits as read back as the same number; empty where it is not known.
std::string exactMetricText(const std::optional<double>& value);
/// Five digits, "-" where it is not known.
std::string shortMetricText(const std::optional<double>& value);
/// What JSON has no number for is text: "inf".
nlohmann::ordered_json metricJson(const std::optional<double>& value);
/// [{"id", "unit", "description"}, …]
nlohmann::ordered_json metricsJson(const std::vector<Metric>& metrics);
/// {"frame": 3, "rmse": …}, …
nlohmann::ordered_json framesJson(const LaneMetrics& lane, const std::vector<Metric>& metrics);
/// {"rmse": …}, each the mean over the frames.
nlohmann::ordered_json meansJson(const LaneMetrics& lane, const std::vector<Metric>& metrics);

} // namespace taa
