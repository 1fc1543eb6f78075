// taa-batch sweep: many settings on many shots, by as many processes as there are.
#include "core/cli/Commands.h"
#include "core/cli/Terminal.h"

#include "core/base/Error.h"
#include "core/sweep/PointMeasurer.h"
#include "core/sweep/SweepFolder.h"
#include "core/sweep/SweepRun.h"
#include "core/sweep/SweepSpec.h"
#include "core/sweep/SweepTable.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

namespace taa::cli {

using nlohmann::ordered_json;

namespace {

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

} // namespace

bool runSweep(const SweepArguments& arguments, std::ostream& out, const Progress& progress) {
  const SweepShard shard = parseShard(arguments.shard);
  const SweepSpec spec = readSweepSpec(arguments.spec);
  const SweepFolder folder(arguments.folder);
  PointMeasurer measurer(spec, sceneBudget(arguments.sceneMillions, arguments.sceneMiB));
  const MeasurePoint measure = [&](const SweepPoint& point, const Progress& inside) {
    return measurer.measure(point, inside);
  };
  const SweepRequest request{spec, folder, shard};
  SweepReport report;
  try {
    report = taa::runSweep(request, measure, progress);
  } catch (const Cancelled&) {
    writeSweepTables(spec, folder); // of what there is
    throw;
  }
  const std::vector<std::filesystem::path> files = writeSweepTables(spec, folder);
  for (const SweepFailure& failure : report.failures)
    tell("point " + std::to_string(failure.point), failure.reason);
  if (arguments.json) {
    out << reportJson(report, files).dump(2) << '\n';
  } else {
    printReport(out, report);
    for (const std::filesystem::path& file : files) out << file.string() << '\n';
  }
  return report.failures.empty();
}

} // namespace taa::cli
