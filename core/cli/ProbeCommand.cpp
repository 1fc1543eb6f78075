// taa-batch probe: one pixel of one frame.
#include "core/cli/Commands.h"

#include "core/base/Error.h"
#include "core/cli/Shot.h"
#include "core/cli/Table.h"
#include "core/inspect/ShownPicture.h"
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

// What it says of rows and lanes is the caller's mistake.
Comparison comparisonOf(const ProbeArguments& arguments, const ShotPlan& plan) {
  if (arguments.compare.empty()) return {};
  Comparison comparison;
  try {
    comparison = parseComparison(arguments.compare);
  } catch (const Error& error) {
    throw UsageError(std::string("--compare: ") + error.what());
  }
  if (comparison.kind == OtherKind::Row)
    throw UsageError("--compare: probe prints all rows already: name a preset or a frame");
  if (comparison.kind == OtherKind::Preset && plan.lanes.size() > 1)
    throw UsageError("--compare is of one lane: leave --lane out");
  return comparison;
}

void addOtherSide(Inspector& inspector, const Comparison& comparison, const glm::ivec2& pixel, int lane,
                  ProbedLane& probed, const Progress& progress) {
  if (!comparison) return;
  OtherSide other = otherSideOf(comparison, IntermediateId::resolved, 1);
  if (comparison.kind != OtherKind::Preset) other.lane = lane;
  const PictureSource source = otherSource(other, inspector.shot().frame(), inspector.shot().frameCount());
  if (source.frame) inspector.views().keepComparisonFrames({*source.frame}, progress);
  probed.compared = inspector.probes().compared(pixel, source, lane);
}

} // namespace

void runProbe(const ProbeArguments& arguments, std::ostream& out, const Progress& progress) {
  ShotPlan plan = planShot(arguments.shot);
  const Comparison comparison = comparisonOf(arguments, plan);
  const auto laneCount = static_cast<int>(plan.lanes.size());
  if (comparison.kind == OtherKind::Preset) plan.lanes.push_back(laneOfPreset("other", comparison.preset));
  const glm::ivec2 pixel = parsePixel(arguments.pixel);
  const int frame = arguments.frame >= 0 ? arguments.frame : plan.frame;
  if (frame < 0) throw UsageError("--frame is required: the number of a frame, from 0");
  Inspector inspector;
  openShot(inspector, arguments.shot, plan, progress);
  requireFrame(inspector, frame);
  requirePixel(inspector, pixel);
  inspector.shot().seek(frame, progress);

  ProbeReport report{shotFacts(inspector), pixel, {}, comparison};
  for (int lane = 0; lane < laneCount; ++lane) {
    const LaneChoice& choice = plan.lanes.at(static_cast<std::size_t>(lane));
    ProbedLane probed{laneFacts(inspector, choice, lane), inspector.probes().probe(pixel.x, pixel.y, lane)};
    probed.details = std::make_shared<twin::Details>(inspector.probes().details(pixel.x, pixel.y, lane));
    if (arguments.whatIf) probed.whatIf = inspector.probes().whatIf(pixel.x, pixel.y, lane);
    addOtherSide(inspector, comparison, pixel, lane, probed, progress);
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
    if (lane.compared) out << comparedText(comparison, *lane.compared) << '\n';
    out << probeTable(lane, pixel);
    if (!lane.whatIf.empty()) printWhatIf(out, lane.whatIf);
  }
}

} // namespace taa::cli
