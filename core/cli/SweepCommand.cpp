// taa-batch sweep: many settings on many shots, by as many processes as there are.
#include "core/cli/Command.h"
#include "core/cli/Shot.h"
#include "core/cli/Terminal.h"
#include "core/sweep/PointMeasurer.h"
#include "core/sweep/SweepFolder.h"
#include "core/sweep/SweepRun.h"
#include "core/sweep/SweepSpec.h"
#include "core/sweep/SweepTable.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace taa::cli {

using nlohmann::ordered_json;

namespace {

struct SweepCommand final : Command {
  std::string spec, folder;
  std::string shard = "1/1";
  int sceneMillions = kDefaultSceneMillions, sceneMiB = kDefaultSceneMiB; ///< what each scene may ask for
  bool json = false;

  SweepCommand() : Command("sweep") {
    description("Measure settings, ranges of parameters and scenes in all combinations that a file names, in "
                "parts where several processes share them, and go on after being stopped");
    add_option("SPEC", spec, "A JSON file: what to go over (manual, sweep)")->required();
    add_option("--out", folder, "Folder of the results; what is there is not computed again")->required();
    add_option("--shard", shard, "I/N: only the I-th of N parts of the points, from 1");
    addSceneBudget(*this, sceneMillions, sceneMiB);
    addJson(*this, json);
  }

  int run(std::ostream& out, const Progress& progress) const override;
};

SweepShard parseShard(const std::string& text) {
  const std::optional<glm::ivec2> shard = parsePair(text, "/");
  if (!shard || shard->x < 1 || shard->x > shard->y)
    throw UsageError("--shard " + text + ": expected I/N, the I-th of N parts, for example 1/4");
  return {static_cast<std::size_t>(shard->x), static_cast<std::size_t>(shard->y)};
}

std::string pointCount(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " point" : " points");
}

void printReport(std::ostream& out, const SweepReport& report) {
  out << pointCount(report.points) << ": " << report.kept << " there already, " << report.computed
      << " computed";
  if (!report.failures.empty()) out << ", " << report.failures.size() << " failed";
  out << '\n';
}

ordered_json reportJson(const SweepReport& report, const std::vector<std::filesystem::path>& files) {
  ordered_json json = {{"points", report.points},
                       {"kept", report.kept},
                       {"computed", report.computed},
                       {"failures", ordered_json::array()},
                       {"files", ordered_json::array()}};
  for (const SweepFailure& failure : report.failures)
    json["failures"].push_back({{"point", failure.point}, {"reason", failure.reason}});
  for (const std::filesystem::path& file : files) json["files"].push_back(file.string());
  return json;
}

int SweepCommand::run(std::ostream& out, const Progress& progress) const {
  const SweepShard part = parseShard(shard);
  const SweepSpec read = readSweepSpec(spec);
  const SweepFolder results(folder);
  PointMeasurer measurer(read, sceneBudget(sceneMillions, sceneMiB));
  const MeasurePoint measure = [&](const SweepPoint& point, const Progress& inside) {
    return measurer.measure(point, inside);
  };
  SweepReport report;
  try {
    report = runSweep({read, results, part}, measure, progress);
  } catch (const Cancelled&) {
    writeSweepTables(read, results); // of what there is
    throw;
  }
  const std::vector<std::filesystem::path> files = writeSweepTables(read, results);
  for (const SweepFailure& failure : report.failures)
    tell("point " + std::to_string(failure.point), failure.reason);
  if (json) {
    print(out, reportJson(report, files));
  } else {
    printReport(out, report);
    for (const std::filesystem::path& file : files) out << file.string() << '\n';
  }
  return report.failures.empty() ? kDone : kWorldsFault;
}

} // namespace

std::shared_ptr<Command> sweepCommand() {
  return std::make_shared<SweepCommand>();
}

} // namespace taa::cli
