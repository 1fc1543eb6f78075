// taa-batch probe: one pixel of one frame.
#include "core/cli/Commands.h"

#include "core/base/Error.h"
#include "core/cli/Shot.h"
#include "core/cli/Table.h"
#include "core/io/FrameJson.h"

#include <cstddef>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace taa::cli {

namespace {

void printWhatIf(std::ostream& out, const std::vector<WhatIfRow>& variants) {
  std::vector<std::vector<std::string>> rows{
      {"", "", "resolved R", "G", "B", "difference R", "G", "B", "alpha", ""}};
  for (const WhatIfRow& row : variants) {
    const bool isFirst = &row == variants.data() || (&row - 1)->group != row.group;
    std::vector<std::string> cells{std::string(isFirst ? whatIfGroupLabel(row.group) : ""),
                                   (row.isCurrent ? "* " : "  ") + row.label};
    for (const glm::vec3& color : {row.resolved, row.difference})
      for (int channel = 0; channel < 3; ++channel) cells.push_back(floatText(color[channel]));
    cells.push_back(floatText(row.alpha));
    cells.push_back(row.rejectReason == 0 ? row.note
                                          : std::string(rejectReasonText(row.rejectReason)) +
                                                (row.note.empty() ? "" : "; " + row.note));
    rows.push_back(std::move(cells));
  }
  out << "What if\n";
  printTable(out, rows, "  ");
}

} // namespace

void runProbe(const ProbeArguments& arguments, std::ostream& out, const Progress& progress) {
  const ShotPlan plan = planShot(arguments.shot);
  const glm::ivec2 pixel = parsePixel(arguments.pixel);
  const int frame = arguments.frame >= 0 ? arguments.frame : plan.frame;
  if (frame < 0) throw UsageError("--frame is required: the number of a frame, from 0");
  Inspector inspector;
  openShot(inspector, arguments.shot, plan, progress);
  requireFrame(inspector, frame);
  inspector.shot().seek(frame, progress);

  ProbeReport report{shotFacts(inspector), pixel, {}};
  for (int lane = 0; lane < inspector.shot().laneCount(); ++lane) {
    const LaneChoice& choice = plan.lanes.at(static_cast<std::size_t>(lane));
    ProbedLane probed{laneFacts(inspector, choice, lane), inspector.probes().probe(pixel.x, pixel.y, lane)};
    probed.details = std::make_shared<twin::Details>(inspector.probes().details(pixel.x, pixel.y, lane));
    if (arguments.whatIf) probed.whatIf = inspector.probes().whatIf(pixel.x, pixel.y, lane);
    report.lanes.push_back(std::move(probed));
  }
  if (arguments.json) {
    out << probeJson(report).dump(2) << '\n';
    return;
  }
  for (const ProbedLane& lane : report.lanes) {
    if (!lane.lane.name.empty())
      out << (&lane == report.lanes.data() ? "" : "\n") << "LANE " << lane.lane.name << ": "
          << lane.lane.preset << '\n';
    out << probeTable(lane, pixel);
    if (!lane.whatIf.empty()) printWhatIf(out, lane.whatIf);
  }
}

} // namespace taa::cli
