// taa-batch metrics: metrics of a range of frames, against the supersampled reference and of the resolve.
#include "core/base/Error.h"
#include "core/cli/Commands.h"
#include "core/cli/Shot.h"
#include "core/cli/Table.h"
#include "core/sweep/MetricsOfFrames.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <set>
#include <string>
#include <vector>

namespace taa::cli {

using nlohmann::ordered_json;

namespace {

void printLane(std::ostream& out, const LaneMetrics& lane, const std::vector<Metric>& wanted) {
  std::vector<std::vector<std::string>> table{{"FRAME"}};
  for (const Metric metric : wanted) table[0].push_back(metricHeading(metric));
  for (const FrameMetrics& frame : lane) {
    table.push_back({std::to_string(frame.frame)});
    for (const Metric metric : wanted) table.back().push_back(shortMetricText(frame.at(metric)));
  }
  table.push_back({"mean"});
  for (const Metric metric : wanted) table.back().push_back(shortMetricText(meanOfFrames(lane, metric)));
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
      for (const Metric metric : wanted) out << ',' << exactMetricText(frame.at(metric));
      out << '\n';
    }
}

ordered_json laneOf(const Inspector& inspector, const LaneMetrics& metrics, const LaneChoice& choice,
                    int index, const std::vector<Metric>& wanted) {
  ordered_json json = laneJson(inspector, choice, index);
  json.erase("jitterIndex"); // of the last frame only
  json.erase("jitterPx");
  json["frames"] = framesJson(metrics, wanted);
  json["mean"] = meansJson(metrics, wanted);
  return json;
}

void printJson(std::ostream& out, const Inspector& inspector, const std::vector<LaneMetrics>& lanes,
               const ShotPlan& plan, int referenceSamples, const std::vector<Metric>& wanted) {
  ordered_json json = shotJson(inspector);
  json["referenceSamples"] = referenceSamples;
  if (std::ranges::any_of(wanted, [](Metric metric) { return metricInfo(metric).isOverTime; }))
    json["flickerFrames"] = inspector.overTime().frames();
  json["metrics"] = metricsJson(wanted);
  for (std::size_t lane = 0; lane < lanes.size(); ++lane)
    json["lanes"].push_back(
        laneOf(inspector, lanes[lane], plan.lanes.at(lane), static_cast<int>(lane), wanted));
  out << json.dump(2) << '\n';
}

std::vector<OverTime> askedKinds(const MetricsArguments& arguments) {
  std::vector<OverTime> kinds;
  if (arguments.flicker) kinds.push_back(OverTime::Flicker);
  if (arguments.parts) kinds.push_back(OverTime::Parts);
  return kinds;
}

Metric parseMetric(const std::string& id) {
  try {
    return metricNamed(id);
  } catch (const Error& error) {
    throw UsageError(std::string("--metrics: ") + error.what());
  }
}

std::vector<Metric> wantedMetrics(const MetricsArguments& arguments) {
  const std::vector<OverTime> kinds = askedKinds(arguments);
  const int samples = arguments.referenceSamples;
  if (arguments.parts && samples == 0)
    throw UsageError("--parts needs a reference: --reference-samples above 0");
  if (arguments.named.empty()) return metricsThere(samples, kinds);
  if (!kinds.empty())
    throw UsageError("--metrics names all that is measured: leave out --flicker and --parts");
  std::set<Metric> wanted; // in the order of the table
  for (const std::string& id : arguments.named) {
    const Metric metric = parseMetric(id);
    if (metricInfo(metric).needsReference && samples == 0)
      throw UsageError("--metrics " + id + " needs a reference: --reference-samples above 0");
    wanted.insert(metric);
  }
  return {wanted.begin(), wanted.end()};
}

} // namespace

void runMetrics(const MetricsArguments& arguments, std::ostream& out, const Progress& progress) {
  if (arguments.json && arguments.csv) throw UsageError("--json and --csv: only one of them");
  const ShotPlan plan = planShot(arguments.shot);
  const FrameRange range = parseFrames(arguments.frames);
  const int samples = arguments.referenceSamples;
  if (samples != 0) checkReferenceSamples(samples);
  const std::vector<Metric> wanted = wantedMetrics(arguments);
  Inspector inspector;
  inspector.overTime().setFrames(arguments.flickerFrames);
  openShot(inspector, arguments.shot, plan, progress);
  requireFrame(inspector, plan, range.last);
  try {
    requireMeasurable(inspector, samples);
  } catch (const Error& error) {
    throw UsageError(std::string(error.what()) + "; --reference-samples 0 measures without one");
  }
  const std::vector<LaneMetrics> lanes =
      measureFrames(inspector, {range.first, range.last, wanted, samples}, progress);
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
