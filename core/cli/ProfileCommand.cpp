// taa-batch profile: where the time of frames goes, pass by pass, and what the settings of each stage cost.
#include "core/base/Median.h"
#include "core/base/NumberText.h"
#include "core/cli/Command.h"
#include "core/cli/Shot.h"
#include "core/cli/Table.h"
#include "core/io/FrameJson.h"

#include <algorithm>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace taa::cli {

using nlohmann::ordered_json;

namespace {

struct ProfileCommand final : Command {
  ShotOptions shot;
  std::string frames = "1..30";
  bool json = false;

  ProfileCommand() : Command("profile") {
    description(
        "Print the time of each pass, what the settings of each stage of the resolve cost more than the "
        "cheapest ones, and the memory in use");
    addShotOptions(*this, shot);
    add_option("--frames", frames, "A..B, both included, from 1")->capture_default_str();
    addJson(*this, json);
  }
  int run(std::ostream& out, const Progress& progress) const override;
};

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
                    {"cheapestMs", costs.cheapest.median},
                    {"cheapestRangeMs", {costs.cheapest.low, costs.cheapest.high}},
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
  std::vector<std::vector<std::string>> table{{"STAGE, ABOVE THE CHEAPEST", "MS", "±", "SHARE", ""}};
  const auto add = [&](std::string name, const Measured& ms, const std::string& part) {
    table.push_back({std::move(name), fixedText(ms.median, 3), fixedText(ms.spread(), 3), part, ""});
  };
  for (const StageCost& cost : costs.stages) {
    const bool isClear = cost.verdict() == CostVerdict::Clear;
    add(std::string(stageInfo(cost.stage).label), cost.ms,
        isClear ? share(cost.ms.median, costs.whole.median) : "");
    if (cost.verdict() == CostVerdict::Noise) table.back()[1] = "";
    if (cost.isCheapest) table.back()[2] = "";
    table.back().back() = verdictWords(cost);
  }
  add("All cheapest", costs.cheapest, share(costs.cheapest.median, costs.whole.median));
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

int ProfileCommand::run(std::ostream& out, const Progress& progress) const {
  const ShotPlan plan = planShot(shot);
  if (plan.lanes.size() != 1) throw UsageError("profile takes one lane: use --preset instead of --lane");
  const FrameRange range = parseFrames(frames);
  if (range.first < 1) throw UsageError("--frames " + frames + ": frame 0 has no history; start from 1");
  Inspector inspector;
  openShot(inspector, plan, progress);
  requireFrame(inspector, plan, range.last);
  inspector.shot().seek(range.first, progress); // compiles: nothing of that is measured
  inspector.shot().seek(range.first - 1, progress);
  inspector.profiler().setProfiling(true);
  std::vector<PassRow> passes;
  FrameProfile last;
  for (int frame = range.first; frame <= range.last; ++frame) {
    report(progress, "Profiling frames", frame - range.first, range.count());
    inspector.shot().advance();
    last = inspector.profiler().takeProfile().value();
    add(passes, last);
  }
  inspector.profiler().setProfiling(false);
  const StageCosts costs = inspector.profiler().measureStages(progress);
  if (json) {
    ordered_json result = shotJson(inspector);
    result["frames"] = {range.first, range.last};
    result.update(profileJson(passes, last, costs));
    print(out, result);
    return kDone;
  }
  out << inspector.shot().driver().renderer << ", " << inspector.shot().width() << " × "
      << inspector.shot().height() << ": " << timingWords(last.method) << "\n\n";
  printPasses(out, passes);
  out << '\n';
  printStages(out, costs);
  out << '\n';
  printMemory(out, last);
  return kDone;
}

} // namespace

std::shared_ptr<Command> profileCommand() {
  return std::make_shared<ProfileCommand>();
}

} // namespace taa::cli
