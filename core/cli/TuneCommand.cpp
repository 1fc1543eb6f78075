// taa-batch tune: settings that serve a goal better on some frames, as a preset and as GLSL.
#include "core/base/ExistingFiles.h"
#include "core/base/Files.h"
#include "core/cli/Command.h"
#include "core/cli/Shot.h"
#include "core/cli/Table.h"
#include "core/measure/Flicker.h"
#include "core/render/CaptureFacts.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"
#include "core/sweep/MetricsOfFrames.h"
#include "core/sweep/tune/Tuning.h"
#include "core/taa/GlslExport.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace taa::cli {

using nlohmann::ordered_json;

namespace {

struct TuneCommand final : Command {
  ShotOptions shot;
  std::string goal = kDefaultGoal; ///< "METRIC=WEIGHT,…"
  std::string frames;              ///< empty: that of the session
  std::string preset, glsl;        ///< files; glsl empty: none
  std::vector<std::string> varied; ///< paths or groups; empty: all of the resolve
  int referenceSamples = kReferenceSamples, flickerFrames = kFlickerFrames;
  int evaluations = 200;
  int seconds = 0; ///< instead of evaluations; 0: those
  unsigned seed = 1;
  bool trades = false; ///< RMSE and flicker may become worse
  bool force = false, json = false;

  TuneCommand() : Command("tune") {
    description(
        "Find settings of the resolve that serve a goal better than those it is given, on some frames");
    addShotOptions(*this, shot);
    add_option("--goal", goal,
               "METRIC=WEIGHT with commas between, of the metrics that metrics --json names, and cost, the "
               "time of the resolve; each counts relative to what it is at the start")
        ->capture_default_str();
    add_flag("--trade", trades,
             "RMSE and flicker may become worse where the goal gains by it; else nothing is kept that raises "
             "one of them by more than 1 %");
    add_option("--frames", frames, "A..B, both included: what is measured; else the session's frame");
    addReferenceSamples(*this, referenceSamples, "of the reference, 4 to 1024");
    add_option("--flicker-frames", flickerFrames, "Frames that flicker is taken over, 2 to 64")
        ->check(CLI::Range(kMinFlickerFrames, kMaxFlickerFrames))
        ->capture_default_str();
    CLI::Option* budget = add_option("--budget", evaluations, "Settings that are measured at most")
                              ->check(CLI::Range(1, 1'000'000))
                              ->capture_default_str();
    add_option("--seconds", seconds, "How long to look, instead of --budget")
        ->check(CLI::Range(1, 1'000'000))
        ->excludes(budget);
    add_option("--vary", varied,
               "A parameter, or a group of them such as rectify, that may change; repeat it for more. "
               "Without it all numbers, switches and choices of the resolve may")
        ->allow_extra_args(false);
    add_option("--seed", seed, "Another order of trying")->capture_default_str();
    add_option("--out", preset, "The preset that is written, a .json file")->required();
    add_option("--glsl", glsl, "Also write its resolve as one GLSL file");
    addForce(*this, force);
    addJson(*this, json);
  }

  int run(std::ostream& out, const Progress& progress) const override;
};

FrameRange tunedFrames(const TuneCommand& command, const ShotPlan& plan) {
  if (!command.frames.empty()) return parseFrames(command.frames);
  if (plan.sessionFrame < 0) throw UsageError("--frames is required: A..B, for example 8..31, or one frame");
  return {plan.sessionFrame, plan.sessionFrame};
}

/// What can be wrong before anything is opened.
void checkTuning(const TuneCommand& command) {
  readOption("--vary", [&] { return tunableRows(command.varied); });
  checkReferenceSamples(command.referenceSamples);
  if (!command.preset.ends_with(".json"))
    throw UsageError("--out " + command.preset + ": expected a .json file");
  std::vector<std::filesystem::path> files{command.preset};
  if (!command.glsl.empty()) files.emplace_back(command.glsl);
  if (!command.force) refuseToReplace(files);
}

/// Without a reference what needs none is tuned, and RMSE is not looked at.
TuneRequest tuneRequestOf(const TuneCommand& command, const FrameRange& frames, const Inspector& inspector) {
  const auto captured = inspector.shot().capture();
  const int samples = captured && !captured->hasReference ? 0 : command.referenceSamples;
  return {.goal = command.goal,
          .varied = command.varied,
          .metrics = {frames.first, frames.last, {}, samples},
          .seed = command.seed,
          .evaluations = command.evaluations,
          .seconds = command.seconds,
          .trades = command.trades};
}

std::vector<std::filesystem::path> writeTuned(const TuneCommand& command, const ShotPlan& plan,
                                              const Settings& settings) {
  const std::string name = std::filesystem::path(command.preset).stem().string();
  const std::string description =
      "Tuned from " + plan.lanes.front().preset + " on " + plan.source + " for " + command.goal + ".";
  writeFile(command.preset, presetToText({name, name, "", 0, description, settings}));
  if (command.glsl.empty()) return {command.preset};
  writeFile(command.glsl, exportedGlsl(settings, settingsTitle(name, settings, settings)));
  return {command.preset, command.glsl};
}

std::optional<double> guardedMean(Metric metric, const TuneNumbers& numbers) {
  return numbers.means[static_cast<std::size_t>(metric)];
}

/// Guarded metrics that the goal does not count.
std::vector<Metric> uncountedGuards(const TuneGoal& goal) {
  std::vector<Metric> guards(kGuardedMetrics.begin(), kGuardedMetrics.end());
  for (const Metric counted : goal.metrics()) std::erase(guards, counted);
  return guards;
}

void printTuned(std::ostream& out, const Tuning& tuning) {
  const TuneResult& result = tuning.result();
  std::vector<std::vector<std::string>> way{{"EVALUATION", "GOAL", "CHANGE"},
                                            {"1", shortMetricText(result.startGoal), "the start"}};
  for (const TuneStep& step : result.steps)
    way.push_back({std::to_string(step.evaluation), shortMetricText(step.goal), step.change});
  printTable(out, way);
  out << '\n';
  std::vector<std::vector<std::string>> numbers{{"", "WEIGHT", "START", "BEST"}};
  for (const GoalTerm& term : tuning.goal().terms())
    numbers.push_back({termName(term), shortMetricText(term.weight),
                       shortMetricText(termNumber(term, tuning.start())),
                       shortMetricText(termNumber(term, tuning.best()))});
  for (const Metric metric : uncountedGuards(tuning.goal()))
    numbers.push_back({metricHeading(metric), "-", shortMetricText(guardedMean(metric, tuning.start())),
                       shortMetricText(guardedMean(metric, tuning.best()))});
  numbers.push_back({"goal", "", shortMetricText(result.startGoal), shortMetricText(result.goal)});
  printTable(out, numbers);
  for (const WorseMetric& worse : worseMetrics(tuning.best(), tuning.start()))
    out << metricInfo(worse.metric).id << " is worse than at the start, by "
        << shortMetricText(100.0 * worse.rise) << " %\n";
  out << '\n'
      << result.evaluations << " settings measured; "
      << (result.isComplete ? "no single change is better" : "stopped before everything was tried") << '\n';
}

ordered_json tunedJson(const Inspector& inspector, const Tuning& tuning, const FrameRange& frames) {
  const TuneResult& result = tuning.result();
  ordered_json json = shotJson(inspector);
  json["frames"] = {frames.first, frames.last};
  for (const GoalTerm& term : tuning.goal().terms())
    json["goal"].push_back({{"metric", term.metric ? metricInfo(*term.metric).id : kCostGoal},
                            {"weight", term.weight},
                            {"start", metricJson(termNumber(term, tuning.start()))},
                            {"best", metricJson(termNumber(term, tuning.best()))}});
  for (const Metric metric : kGuardedMetrics)
    json["guarded"].push_back({{"metric", metricInfo(metric).id},
                               {"start", metricJson(guardedMean(metric, tuning.start()))},
                               {"best", metricJson(guardedMean(metric, tuning.best()))}});
  json["worse"] = ordered_json::array();
  for (const WorseMetric& worse : worseMetrics(tuning.best(), tuning.start()))
    json["worse"].push_back({{"metric", metricInfo(worse.metric).id}, {"rise", worse.rise}});
  json["startGoal"] = metricJson(result.startGoal);
  json["bestGoal"] = metricJson(result.goal);
  json["evaluations"] = result.evaluations;
  json["complete"] = result.isComplete;
  json["steps"] = ordered_json::array();
  for (const TuneStep& step : result.steps)
    json["steps"].push_back({{"evaluation", step.evaluation}, {"goal", step.goal}, {"change", step.change}});
  return json;
}

int TuneCommand::run(std::ostream& out, const Progress& progress) const {
  const ShotPlan plan = planShot(shot);
  if (plan.lanes.size() != 1) throw UsageError("tune takes one lane: use --preset instead of --lane");
  const TuneGoal parsed = readOption("--goal", [&] { return TuneGoal(goal); });
  const FrameRange range = tunedFrames(*this, plan);
  checkTuning(*this);
  Inspector inspector;
  inspector.overTime().setFrames(flickerFrames);
  openShot(inspector, plan, progress);
  requireFrame(inspector, plan, range.last);
  for (const Metric metric : parsed.metrics())
    if (metricInfo(metric).needsReference) requireMeasurable(inspector, referenceSamples);
  Tuning tuning(inspector, tuneRequestOf(*this, range, inspector), progress);
  const std::exception_ptr ended = tuning.run();
  if (!tuning.hasStart()) std::rethrow_exception(ended);
  const std::vector<std::filesystem::path> files = writeTuned(*this, plan, tuning.result().settings);
  if (json) {
    ordered_json result = tunedJson(inspector, tuning, range);
    for (const std::filesystem::path& file : files) result["files"].push_back(file.string());
    print(out, result);
  } else {
    printTuned(out, tuning);
    for (const std::filesystem::path& file : files) out << file.string() << '\n';
  }
  if (ended) std::rethrow_exception(ended);
  return kDone;
}

} // namespace

std::shared_ptr<Command> tuneCommand() {
  return std::make_shared<TuneCommand>();
}

} // namespace taa::cli
