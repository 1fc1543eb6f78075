// taa-batch metrics: metrics of a range of frames, against the supersampled reference and of the resolve.
#include "core/cli/Commands.h"
#include "core/render/CaptureFacts.h"

#include "core/cli/Shot.h"
#include "core/cli/Table.h"
#include "core/io/FrameJson.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace taa::cli {

using nlohmann::ordered_json;

namespace {

/// Of one lane, frame by frame.
using LaneMetrics = std::vector<FrameMetrics>;

std::vector<Metric> metricsWanted(const MetricsArguments& arguments) {
  std::vector<Metric> wanted;
  for (const MetricInfo& info : kMetrics)
    if ((arguments.referenceSamples > 0 || !info.needsReference) && (arguments.flicker || !info.isOverTime))
      wanted.push_back(info.metric);
  return wanted;
}

/// Of the frames that have it: nothing changes over time up to the first, or to a cut.
std::optional<double> meanOf(const LaneMetrics& lane, Metric metric) {
  double sum = 0.0;
  int count = 0;
  for (const FrameMetrics& frame : lane) {
    sum += frame.at(metric).value_or(0.0);
    count += frame.at(metric) ? 1 : 0;
  }
  if (count == 0) return {};
  return sum / count;
}

/// As few digits as read back as the same number.
std::string exactText(const std::optional<double>& known) {
  if (!known) return "";
  const double value = *known;
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0.0 ? "inf" : "-inf";
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string shortText(const std::optional<double>& value) {
  if (!value) return "-";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.5g", *value);
  return text.data();
}

ordered_json number(const std::optional<double>& value) {
  if (!value) return nullptr;
  return std::isfinite(*value) ? ordered_json(*value) : ordered_json(exactText(value));
}

std::string heading(Metric metric) {
  const MetricInfo& info = metricInfo(metric);
  return std::string(info.id) + (info.unit.empty() ? "" : " (" + std::string(info.unit) + ")");
}

void printLane(std::ostream& out, const LaneMetrics& lane, const std::vector<Metric>& wanted) {
  std::vector<std::vector<std::string>> table{{"FRAME"}};
  for (const Metric metric : wanted) table[0].push_back(heading(metric));
  for (const FrameMetrics& frame : lane) {
    table.push_back({std::to_string(frame.frame)});
    for (const Metric metric : wanted) table.back().push_back(shortText(frame.at(metric)));
  }
  table.push_back({"mean"});
  for (const Metric metric : wanted) table.back().push_back(shortText(meanOf(lane, metric)));
  printTable(out, table);
}

void printCsv(std::ostream& out, const std::vector<LaneMetrics>& lanes, const ShotPlan& plan,
              const std::vector<Metric>& wanted) {
  out << "frame,lane,preset";
  for (const Metric metric : wanted) out << ',' << metricInfo(metric).id;
  out << '\n';
  for (std::size_t lane = 0; lane < lanes.size(); ++lane)
    for (const FrameMetrics& frame : lanes[lane]) {
      out << frame.frame << ',' << plan.lanes.at(lane).name << ',' << plan.lanes.at(lane).preset;
      for (const Metric metric : wanted) out << ',' << exactText(frame.at(metric));
      out << '\n';
    }
}

ordered_json laneOf(const Inspector& inspector, const LaneMetrics& metrics, const LaneChoice& choice,
                    int index, const std::vector<Metric>& wanted) {
  ordered_json json = laneJson(inspector, choice, index);
  json.erase("jitterIndex"); // of the last frame only
  json.erase("jitterPx");
  for (const FrameMetrics& frame : metrics) {
    ordered_json row = {{"frame", frame.frame}};
    for (const Metric metric : wanted) row[std::string(metricInfo(metric).id)] = number(frame.at(metric));
    json["frames"].push_back(row);
  }
  for (const Metric metric : wanted)
    json["mean"][std::string(metricInfo(metric).id)] = number(meanOf(metrics, metric));
  return json;
}

void printJson(std::ostream& out, const Inspector& inspector, const std::vector<LaneMetrics>& lanes,
               const ShotPlan& plan, int referenceSamples, const std::vector<Metric>& wanted) {
  ordered_json json = shotJson(inspector);
  json["referenceSamples"] = referenceSamples;
  if (std::ranges::any_of(wanted, [](Metric metric) { return metricInfo(metric).isOverTime; }))
    json["flickerFrames"] = inspector.flicker().frames();
  for (const Metric metric : wanted) {
    const MetricInfo& info = metricInfo(metric);
    json["metrics"].push_back({{"id", info.id}, {"unit", info.unit}, {"description", info.description}});
  }
  for (std::size_t lane = 0; lane < lanes.size(); ++lane)
    json["lanes"].push_back(
        laneOf(inspector, lanes[lane], plan.lanes.at(lane), static_cast<int>(lane), wanted));
  out << json.dump(2) << '\n';
}

} // namespace

void runMetrics(const MetricsArguments& arguments, std::ostream& out, const Progress& progress) {
  if (arguments.json && arguments.csv) throw UsageError("--json and --csv: only one of them");
  const ShotPlan plan = planShot(arguments.shot);
  const FrameRange range = parseFrames(arguments.frames);
  const int samples = arguments.referenceSamples;
  if (samples != 0) checkReferenceSamples(samples);
  const std::vector<Metric> wanted = metricsWanted(arguments);
  Inspector inspector;
  inspector.flicker().setFrames(arguments.flickerFrames);
  openShot(inspector, arguments.shot, plan, progress);
  requireFrame(inspector, range.last);
  if (const auto captured = inspector.shot().capture(); captured && !captured->hasReference && samples > 0)
    throw UsageError(whyNoReference() + "; --reference-samples 0 measures without one");
  std::vector<LaneMetrics> lanes(plan.lanes.size());
  for (int frame = range.first; frame <= range.last; ++frame) {
    report(progress, "Measuring frames", frame - range.first, range.count());
    inspector.shot().seek(frame, frame == range.first ? progress : Progress());
    for (int lane = 0; lane < inspector.shot().laneCount(); ++lane) {
      if (samples > 0) inspector.reference().refine(samples, progress, lane);
      if (arguments.flicker) inspector.flicker().refine(samples, progress, lane);
      lanes[static_cast<std::size_t>(lane)].push_back(inspector.metrics().measure(wanted, lane));
    }
  }
  if (arguments.json) return printJson(out, inspector, lanes, plan, samples, wanted);
  if (arguments.csv) return printCsv(out, lanes, plan, wanted);
  for (std::size_t lane = 0; lane < lanes.size(); ++lane) {
    if (!plan.lanes[lane].name.empty())
      out << (lane > 0 ? "\n" : "") << "LANE " << plan.lanes[lane].name << ": " << plan.lanes[lane].preset
          << '\n';
    printLane(out, lanes[lane], wanted);
  }
}

} // namespace taa::cli
