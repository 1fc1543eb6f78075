// taa-batch probe: one pixel of one frame.
#include "core/cli/Commands.h"

#include "core/base/Error.h"
#include "core/cli/Shot.h"
#include "core/cli/Table.h"
#include "core/inspect/ShownPicture.h"
#include "core/inspect/WorstOfShot.h"
#include "core/io/FrameJson.h"
#include "core/picture/RegionSpreadText.h"

#include <cstddef>
#include <memory>
#include <optional>
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

gl::Rect regionOf(const ProbeArguments& arguments) {
  const std::optional<gl::Rect> region = parseRegion(arguments.region);
  if (!region)
    throw UsageError("--region " + arguments.region +
                     ": expected X,Y,WxH, for example 40,20,64x36; 0,0 is the top left");
  return *region;
}

/// What is asked for in place of a pixel is one thing, and what belongs to a pixel is said of one.
void checkPlace(const ProbeArguments& arguments) {
  const int places = (arguments.pixel.empty() ? 0 : 1) + (arguments.find.empty() ? 0 : 1) +
                     (arguments.region.empty() ? 0 : 1);
  if (places != 1)
    throw UsageError(
        "one of --pixel, --find and --region is required; taa-batch probe --help says what they are");
  if (!arguments.region.empty() && (arguments.whatIf || !arguments.compare.empty()))
    throw UsageError("--what-if and --compare are of a pixel, not of a region");
  if (arguments.region.empty() && !arguments.emit.empty())
    throw UsageError("--emit is of a region: probe prints all rows of a pixel");
}

glm::ivec2 foundPixel(Inspector& inspector, const std::string& find) {
  const WorstStep step = find == "rejected"  ? WorstStep::Rejected
                         : find == "clipped" ? WorstStep::Clipped
                                             : WorstStep::NoNumber;
  return inspector.worst().next(IntermediateId::resolved, 0, {}, step).worst.pixel;
}

/// Of the rows that are asked for, those that are made.
std::vector<IntermediateId> rowsOf(const ProbeArguments& arguments) {
  if (!arguments.emit.empty()) return parseEmit(arguments.emit);
  std::vector<IntermediateId> rows;
  for (const Intermediate& row : kIntermediates)
    if (!isOfReference(row.id)) rows.push_back(row.id);
  return rows;
}

std::vector<IntermediateId> resolvedRows(const ProbeArguments& arguments) {
  std::vector<IntermediateId> rows = rowsOf(arguments);
  std::erase_if(rows, isOfReference);
  return rows;
}

void printSpreads(std::ostream& out, const std::vector<RegionSpread>& spreads,
                  const std::vector<IntermediateId>& rows, const SpaceSettings& space) {
  std::vector<std::vector<std::string>> lines{spreadHeader()};
  for (std::size_t index = 0; index < rows.size(); ++index) {
    const Intermediate& row = intermediate(rows[index]);
    if (!spreads[index].categories.empty()) {
      lines.push_back({std::string(row.name) + "  " + categoriesText(spreads[index], row)});
      continue;
    }
    for (std::vector<std::string> line : spreadLines(spreads[index], row, space)) {
      line[0] = std::string(row.name) + (line[0].empty() ? "" : " ") + line[0];
      lines.push_back(std::move(line));
    }
    if (const std::string histogram = histogramText(spreads[index]); !histogram.empty())
      lines.push_back({"  " + histogram});
  }
  printTable(out, lines);
}

void runRegion(const ProbeArguments& arguments, const ShotPlan& plan, Inspector& inspector, std::ostream& out,
               const Progress& progress) {
  const gl::Rect asked = regionOf(arguments);
  requirePixel(inspector, {asked.x, asked.y});
  const InspectedShot& shot = inspector.shot();
  const gl::Rect region = *insidePicture(asked, shot.width(), shot.height());
  const std::vector<IntermediateId> rows = rowsOf(arguments);
  nlohmann::ordered_json json = shotJson(inspector);
  json["frame"] = shot.frame();
  json["region"] = {region.x, region.y, region.width, region.height};
  for (int lane = 0; lane < shot.laneCount(); ++lane) {
    const LaneChoice& choice = plan.lanes.at(static_cast<std::size_t>(lane));
    inspector.reference().makeRows(rows, arguments.referenceSamples, progress, lane);
    const SpaceSettings& space = shot.usedSettings(lane).space;
    std::vector<RegionSpread> spreads;
    for (const IntermediateId id : rows)
      spreads.push_back(
          regionSpread(inspector.views().image(id, lane, region), {}, intermediate(id), region));
    nlohmann::ordered_json laneOut = laneJson(inspector, choice, lane);
    for (std::size_t index = 0; index < rows.size(); ++index)
      laneOut["rows"][std::string(intermediate(rows[index]).name)] =
          spreadJson(spreads[index], intermediate(rows[index]), space);
    json["lanes"].push_back(std::move(laneOut));
    if (arguments.json) continue;
    if (lane > 0) out << '\n';
    if (!choice.name.empty()) out << "LANE " << choice.name << ": " << choice.preset << '\n';
    out << "region " << regionPlaceText(region) << " of frame " << shot.frame() << '\n';
    printSpreads(out, spreads, rows, space);
  }
  if (arguments.json) out << json.dump(2) << '\n';
}

} // namespace

void runProbe(const ProbeArguments& arguments, std::ostream& out, const Progress& progress) {
  ShotPlan plan = planShot(arguments.shot);
  const Comparison comparison = comparisonOf(arguments, plan);
  const auto laneCount = static_cast<int>(plan.lanes.size());
  if (comparison.kind == OtherKind::Preset) plan.lanes.push_back(laneOfPreset("other", comparison.preset));
  checkPlace(arguments);
  if (!arguments.pixel.empty())
    parsePixel(arguments.pixel); // what is wrong is said before anything is opened
  if (!arguments.region.empty()) regionOf(arguments);
  parseEmit(arguments.emit);
  checkReferenceSamples(arguments.referenceSamples);
  const int frame = arguments.frame >= 0 ? arguments.frame : plan.frame;
  if (frame < 0) throw UsageError("--frame is required: the number of a frame, from 0");
  Inspector inspector;
  openShot(inspector, arguments.shot, plan, progress);
  requireFrame(inspector, plan, frame);
  if (!arguments.pixel.empty()) requirePixel(inspector, parsePixel(arguments.pixel));
  if (!arguments.region.empty()) inspector.views().watch(resolvedRows(arguments)); // exposed in one run
  inspector.shot().seek(frame, progress);
  if (!arguments.region.empty()) return runRegion(arguments, plan, inspector, out, progress);
  const glm::ivec2 pixel =
      arguments.find.empty() ? parsePixel(arguments.pixel) : foundPixel(inspector, arguments.find);

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
