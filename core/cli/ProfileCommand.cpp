// taa-batch profile: where the time of frames goes, pass by pass and stage by stage.
#include "core/cli/Commands.h"

#include "core/base/Error.h"
#include "core/base/Median.h"
#include "core/base/NumberText.h"
#include "core/cli/Shot.h"
#include "core/cli/Table.h"
#include "core/io/FrameJson.h"

#include <algorithm>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace taa::cli {

using nlohmann::ordered_json;

namespace {

/// Over all frames of the range.
struct PassRow {
  std::string name;
  std::vector<double> milliseconds; // one a frame
};

std::string share(double part, double whole) {
  return whole > 0.0 ? fixedText(100.0 * part / whole, 1) + " %" : "";
}

void add(std::vector<PassRow>& rows, const FrameProfile& profile) {
  for (const PassCost& cost : profile.passes) {
    auto row = std::ranges::find(rows, cost.name, &PassRow::name);
    if (row == rows.end()) row = rows.insert(row, {cost.name, {}});
    row->milliseconds.push_back(cost.milliseconds);
  }
}

ordered_json profileJson(const std::vector<PassRow>& passes, const FrameProfile& last,
                         const StageCosts& costs) {
  ordered_json json;
  json["timing"] = last.method == gl::TimingMethod::Queries ? "queries" : "finish";
  for (const PassRow& row : passes)
    json["passes"].push_back(
        {{"name", row.name}, {"medianMs", median(row.milliseconds)}, {"ms", row.milliseconds}});
  json["stages"] = {{"wholeMs", costs.whole.median},
                    {"wholeRangeMs", {costs.whole.low, costs.whole.high}},
                    {"storeMs", costs.store.median},
                    {"storeRangeMs", {costs.store.low, costs.store.high}},
                    {"rounds", costs.rounds}};
  for (const StageCost& cost : costs.stages)
    json["stages"]["stages"].push_back({{"stage", stageInfo(cost.stage).id},
                                        {"ms", cost.ms.median},
                                        {"rangeMs", {cost.ms.low, cost.ms.high}},
                                        {"isAboveNoise", cost.verdict() == CostVerdict::Clear},
                                        {"note", verdictWords(cost)}});
  for (const MemoryCost& cost : last.memory)
    json["memory"].push_back({{"name", cost.name}, {"bytes", cost.bytes}, {"objects", cost.objects}});
  json["memoryBytes"] = last.memoryBytes;
  json["checkpointBytes"] = last.checkpointBytes;
  return json;
}

void printPasses(std::ostream& out, const std::vector<PassRow>& passes) {
  double sum = 0.0;
  for (const PassRow& row : passes) sum += median(row.milliseconds);
  std::vector<std::vector<std::string>> table{{"PASS", "MS, MEDIAN", "SHARE"}};
  for (const PassRow& row : passes)
    table.push_back({row.name, fixedText(median(row.milliseconds), 3), share(median(row.milliseconds), sum)});
  printTable(out, table);
}

void printStages(std::ostream& out, const StageCosts& costs) {
  std::vector<std::vector<std::string>> table{{"STAGE OF THE RESOLVE", "MS", "±", "SHARE", ""}};
  const auto add = [&](std::string name, const MeasuredMs& ms, const std::string& part) {
    table.push_back({std::move(name), fixedText(ms.median, 3), fixedText(ms.spread(), 3), part, ""});
  };
  for (const StageCost& cost : costs.stages) {
    const bool isClear = cost.verdict() == CostVerdict::Clear;
    add(std::string(stageInfo(cost.stage).label), cost.ms,
        isClear ? share(cost.ms.median, costs.whole.median) : "");
    if (cost.verdict() == CostVerdict::Noise) table.back()[1] = "";
    table.back().back() = verdictWords(cost);
  }
  add("Draw and stores", costs.store, share(costs.store.median, costs.whole.median));
  add("All", costs.whole, "");
  printTable(out, table);
}

void printMemory(std::ostream& out, const FrameProfile& profile) {
  constexpr double kMiB = 1 << 20;
  std::vector<std::vector<std::string>> table{{"RESOURCE", "MIB", "OBJECTS"}};
  for (const MemoryCost& cost : profile.memory)
    table.push_back(
        {cost.name, fixedText(static_cast<double>(cost.bytes) / kMiB, 2), std::to_string(cost.objects)});
  table.push_back({"All", fixedText(static_cast<double>(profile.memoryBytes) / kMiB, 2), ""});
  table.push_back(
      {"of it checkpoints", fixedText(static_cast<double>(profile.checkpointBytes) / kMiB, 2), ""});
  printTable(out, table);
}

} // namespace

void runProfile(const ProfileArguments& arguments, std::ostream& out, const Progress& progress) {
  const ShotPlan plan = planShot(arguments.shot);
  if (plan.lanes.size() != 1) throw UsageError("profile takes one lane: use --preset instead of --lane");
  const FrameRange frames = parseFrames(arguments.frames);
  if (frames.first < 1)
    throw UsageError("--frames " + arguments.frames + ": frame 0 has no history; start from 1");
  Inspector inspector;
  openShot(inspector, arguments.shot, plan, progress);
  requireFrame(inspector, plan, frames.last);
  inspector.shot().seek(frames.first, progress); // compiles: nothing of that is measured
  inspector.shot().seek(frames.first - 1, progress);
  inspector.profiler().setProfiling(true);
  std::vector<PassRow> passes;
  FrameProfile last;
  for (int frame = frames.first; frame <= frames.last; ++frame) {
    report(progress, "Profiling frames", frame - frames.first, frames.count());
    inspector.shot().advance();
    last = inspector.profiler().takeProfile().value();
    add(passes, last);
  }
  inspector.profiler().setProfiling(false);
  const StageCosts costs = inspector.profiler().measureStages(progress);
  if (arguments.json) {
    ordered_json json = shotJson(inspector);
    json["frames"] = {frames.first, frames.last};
    json.update(profileJson(passes, last, costs));
    out << json.dump(2) << '\n';
    return;
  }
  out << inspector.shot().driver().renderer << ", " << inspector.shot().width() << " × "
      << inspector.shot().height() << ": " << timingWords(last.method) << "\n\n";
  printPasses(out, passes);
  out << '\n';
  printStages(out, costs);
  out << '\n';
  printMemory(out, last);
}

} // namespace taa::cli
