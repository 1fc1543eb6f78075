// taa-batch tune: settings that serve a goal better on some frames, as a preset and as GLSL.
#include "core/base/Error.h"
#include "core/base/ExistingFiles.h"
#include "core/base/Files.h"
#include "core/cli/Commands.h"
#include "core/cli/Shot.h"
#include "core/cli/Table.h"
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
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace taa::cli {

using nlohmann::ordered_json;

namespace {

TuneGoal parseGoal(const std::string& text) {
  try {
    return TuneGoal(text);
  } catch (const Error& error) {
    throw UsageError(std::string("--goal: ") + error.what());
  }
}

std::vector<const Parameter*> parseVaried(const std::vector<std::string>& names) {
  try {
    return tunableRows(names);
  } catch (const Error& error) {
    throw UsageError(std::string("--vary: ") + error.what());
  }
}

FrameRange tunedFrames(const TuneArguments& arguments, const ShotPlan& plan) {
  if (!arguments.frames.empty()) return parseFrames(arguments.frames);
  if (plan.frame < 0) throw UsageError("--frames is required: A..B, for example 8..31, or one frame");
  return {plan.frame, plan.frame};
}

/// What can be wrong before anything is opened.
void checkTuning(const TuneArguments& arguments) {
  parseVaried(arguments.varied);
  checkReferenceSamples(arguments.referenceSamples);
  if (!arguments.preset.ends_with(".json"))
    throw UsageError("--out " + arguments.preset + ": expected a .json file");
  std::vector<std::filesystem::path> files{arguments.preset};
  if (!arguments.glsl.empty()) files.emplace_back(arguments.glsl);
  if (!arguments.force) refuseToReplace(files);
}

/// Without a reference what needs none is tuned, and RMSE is not looked at.
TuneRequest tuneRequestOf(const TuneArguments& arguments, const FrameRange& frames,
                          const Inspector& inspector) {
  const auto captured = inspector.shot().capture();
  const int samples = captured && !captured->hasReference ? 0 : arguments.referenceSamples;
  return {.goal = arguments.goal,
          .varied = arguments.varied,
          .metrics = {frames.first, frames.last, {}, samples},
          .seed = arguments.seed,
          .evaluations = arguments.evaluations,
          .seconds = arguments.seconds,
          .trades = arguments.trades};
}

std::vector<std::filesystem::path> writeTuned(const TuneArguments& arguments, const LaneChoice& choice,
                                              const std::string& source, const Settings& settings) {
  const std::string name = std::filesystem::path(arguments.preset).stem().string();
  const std::string description =
      "Tuned from " + choice.preset + " on " + source + " for " + arguments.goal + ".";
  writeFile(arguments.preset, presetToText({name, name, "", 0, description, settings}));
  if (arguments.glsl.empty()) return {arguments.preset};
  writeFile(arguments.glsl, exportedGlsl(settings, settingsTitle(name, settings, settings)));
  return {arguments.preset, arguments.glsl};
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
      << (result.isComplete ? "no single change is better" : "the search was not at its end") << '\n';
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

} // namespace

void runTune(const TuneArguments& arguments, std::ostream& out, const Progress& progress) {
  const ShotPlan plan = planShot(arguments.shot);
  if (plan.lanes.size() != 1) throw UsageError("tune takes one lane: use --preset instead of --lane");
  const TuneGoal goal = parseGoal(arguments.goal);
  const FrameRange frames = tunedFrames(arguments, plan);
  checkTuning(arguments);
  Inspector inspector;
  inspector.overTime().setFrames(arguments.flickerFrames);
  openShot(inspector, arguments.shot, plan, progress);
  requireFrame(inspector, plan, frames.last);
  for (const Metric metric : goal.metrics())
    if (metricInfo(metric).needsReference) requireMeasurable(inspector, arguments.referenceSamples);
  Tuning tuning(inspector, tuneRequestOf(arguments, frames, inspector), progress);
  const std::exception_ptr ended = tuning.run();
  if (!tuning.hasStart()) std::rethrow_exception(ended);
  const std::vector<std::filesystem::path> files =
      writeTuned(arguments, plan.lanes.front(), plan.source, tuning.result().settings);
  if (arguments.json) {
    ordered_json json = tunedJson(inspector, tuning, frames);
    for (const std::filesystem::path& file : files) json["files"].push_back(file.string());
    out << json.dump(2) << '\n';
  } else {
    printTuned(out, tuning);
    for (const std::filesystem::path& file : files) out << file.string() << '\n';
  }
  if (ended) std::rethrow_exception(ended);
}

} // namespace taa::cli
