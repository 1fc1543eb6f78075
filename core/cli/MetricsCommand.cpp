// taa-batch metrics: metrics of a range of frames, against the supersampled reference and of the resolve.
#include "core/cli/Command.h"
#include "core/cli/Shot.h"
#include "core/cli/Table.h"
#include "core/measure/Flicker.h"
#include "core/sweep/MetricsOfFrames.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <ostream>
#include <set>
#include <string>
#include <vector>

namespace taa::cli {

using nlohmann::ordered_json;

namespace {

struct MetricsCommand final : Command {
  ShotOptions shot;
  std::string frames;
  int referenceSamples = kReferenceSamples; ///< 0: nothing is compared with a reference
  bool flicker = false;           ///< also what is over time: frames before those, and their references
  bool parts = false;             ///< also what the error is made of, over those frames
  std::vector<std::string> named; ///< ids of these alone; empty: all that are not costly
  int flickerFrames = kFlickerFrames;
  bool json = false, csv = false;

  MetricsCommand() : Command("metrics") {
    description("Print RMSE and PSNR of frames against a supersampled reference, and what the resolve did");
    addShotOptions(*this, shot);
    add_option("--frames", frames, "A..B, both included, or one frame")->required();
    addReferenceSamples(*this, referenceSamples, "of the reference, 4 to 1024; 0: draw none");
    add_flag(
        "--flicker", flicker,
        "Also measure how much each pixel changes over the last frames, followed along its motion: more than "
        "its reference does, which is drawn for those frames too, or with --reference-samples 0 in all");
    add_flag("--parts", parts,
             "Also split the error into ghost, lag, blur, aliasing, rectification and what is older than "
             "those frames, and count where history was rightly removed, let through or thrown away");
    add_option("--metrics", named,
               "Measure these alone, with commas between; hdrFlip, which takes seconds a frame, is measured "
               "only where it is named")
        ->delimiter(',')
        ->allow_extra_args(false);
    add_option("--flicker-frames", flickerFrames, "Frames that flicker and parts are taken over, 2 to 64")
        ->check(CLI::Range(kMinFlickerFrames, kMaxFlickerFrames))
        ->capture_default_str();
    addJson(*this, json);
    add_flag("--csv", csv, "Print comma-separated values, a line for each frame and lane");
  }

  int run(std::ostream& out, const Progress& progress) const override;
};

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

ordered_json laneOf(const Inspector& inspector, const LaneMetrics& metrics, const ShotPlan& plan, int index,
                    const std::vector<Metric>& wanted) {
  ordered_json json = laneJson(inspector, plan, index);
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
    json["lanes"].push_back(laneOf(inspector, lanes[lane], plan, static_cast<int>(lane), wanted));
  print(out, json);
}

std::vector<Metric> wantedMetrics(const MetricsCommand& command) {
  std::vector<OverTime> kinds;
  if (command.flicker) kinds.push_back(OverTime::Flicker);
  if (command.parts) kinds.push_back(OverTime::Parts);
  const int samples = command.referenceSamples;
  if (command.parts && samples == 0)
    throw UsageError("--parts needs a reference: --reference-samples above 0");
  if (command.named.empty()) return metricsThere(samples, kinds);
  if (!kinds.empty())
    throw UsageError("--metrics names all that is measured: leave out --flicker and --parts");
  std::set<Metric> wanted; // in the order of the table
  for (const std::string& id : command.named) {
    const Metric metric = readOption("--metrics", [&] { return metricNamed(id); });
    if (metricInfo(metric).needsReference && samples == 0)
      throw UsageError("--metrics " + id + " needs a reference: --reference-samples above 0");
    wanted.insert(metric);
  }
  return {wanted.begin(), wanted.end()};
}

int MetricsCommand::run(std::ostream& out, const Progress& progress) const {
  if (json && csv) throw UsageError("--json and --csv: only one of them");
  const ShotPlan plan = planShot(shot);
  const FrameRange range = parseFrames(frames);
  if (referenceSamples != 0) checkReferenceSamples(referenceSamples);
  const std::vector<Metric> wanted = wantedMetrics(*this);
  Inspector inspector;
  inspector.overTime().setFrames(flickerFrames);
  openShot(inspector, plan, progress);
  requireFrame(inspector, plan, range.last);
  try {
    requireMeasurable(inspector, referenceSamples);
  } catch (const Error& error) {
    throw UsageError(std::string(error.what()) + "; --reference-samples 0 measures without one");
  }
  const std::vector<LaneMetrics> lanes =
      measureFrames(inspector, {range.first, range.last, wanted, referenceSamples}, progress);
  if (json)
    printJson(out, inspector, lanes, plan, referenceSamples, wanted);
  else if (csv)
    printCsv(out, lanes, plan, wanted);
  else
    for (std::size_t lane = 0; lane < lanes.size(); ++lane) {
      out << laneHeading(plan, static_cast<int>(lane));
      printLane(out, lanes[lane], wanted);
    }
  return kDone;
}

} // namespace

std::shared_ptr<Command> metricsCommand() {
  return std::make_shared<MetricsCommand>();
}

} // namespace taa::cli
