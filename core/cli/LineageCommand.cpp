// taa-batch lineage: which samples one pixel of one frame is made of.
#include "core/cli/Commands.h"
#include "core/cli/Shot.h"
#include "core/cli/Table.h"
#include "core/report/LineageReport.h"
#include "core/verdict/lineage/LineageWords.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <ostream>
#include <string>

namespace taa::cli {

void runLineage(const LineageArguments& arguments, std::ostream& out, const Progress& progress) {
  const ShotPlan plan = planShot(arguments.shot);
  const glm::ivec2 pixel = parsePixel(arguments.pixel);
  const int frame = arguments.frame >= 0 ? arguments.frame : plan.frame;
  if (frame < 0) throw UsageError("--frame is required: the number of a frame, from 0");
  Inspector inspector;
  openShot(inspector, arguments.shot, plan, progress);
  requireFrame(inspector, plan, frame);
  requirePixel(inspector, pixel);
  inspector.shot().seek(frame, progress);

  LineageReport report{shotFacts(inspector), pixel, {}};
  LineageOptions options;
  options.frames = arguments.frames;
  for (int lane = 0; lane < inspector.shot().laneCount(); ++lane)
    report.lanes.push_back({laneFacts(inspector, plan.lanes.at(static_cast<std::size_t>(lane)), lane),
                            inspector.lineage().of(frame, pixel, lane, options, progress)});
  if (arguments.json) {
    out << lineageJson(report).dump(2) << '\n';
    return;
  }
  for (const LineageOfLane& lane : report.lanes) {
    if (&lane != report.lanes.data()) out << '\n';
    out << placeText(report.shot, pixel, lane.lane) << '\n';
    for (const std::string& line : lineageSentences(lane.lineage)) out << line << '\n';
    printTable(out, lineageTable(lane.lineage));
  }
}

} // namespace taa::cli
