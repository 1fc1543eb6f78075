// taa-batch probe: one pixel of one frame.
#include "core/base/ExistingFiles.h"
#include "core/base/NumberText.h"
#include "core/cli/Command.h"
#include "core/cli/Shot.h"
#include "core/cli/Table.h"
#include "core/inspect/MappedShot.h"
#include "core/inspect/ShownPicture.h"
#include "core/inspect/WorstOfShot.h"
#include "core/io/FrameJson.h"
#include "core/io/PictureFile.h"
#include "core/picture/RegionSpreadText.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace taa::cli {

namespace {

/// What --find takes.
const std::vector<std::pair<std::string, WorstStep>> kFindSteps = {
    {"rejected", WorstStep::Rejected}, {"clipped", WorstStep::Clipped}, {"nan", WorstStep::NoNumber}};

/// What --formulas takes.
const std::vector<std::pair<std::string, FormulaDepth>> kDepths = {
    {"rows", FormulaDepth::Rows}, {"stage", FormulaDepth::Stage}, {"samples", FormulaDepth::Samples}};

/// A region with its rows.
struct RegionRequest {
  gl::Rect rect;
  std::vector<IntermediateId> rows;
};

struct ProbeCommand final : Command {
  ShotOptions shot;
  std::string pixel;
  int frame = -1;                               ///< −1: that of the session
  std::string formulas = kDepths.front().first; ///< what they are written down to
  bool json = false;
  bool force = false;                     ///< replaces the picture that is there
  bool whatIf = false;                    ///< also the pixel under other choices
  bool sensitivity = false;               ///< also how much it moves with what it is made of
  std::string compare;                    ///< the other side; empty: none
  std::string region;                     ///< X,Y,WxH instead of a pixel; empty: none
  std::string find;                       ///< of kFindSteps, instead of a pixel; empty: none
  std::string where;                      ///< a number of the settings, instead of a pixel; empty: none
  std::string picture;                    ///< of `where`; empty: none
  std::vector<std::string> emit;          ///< of a region; empty: all of the frame's own resolve
  int referenceSamples = kVerdictSamples; ///< of rows of the reference that are named

  ProbeCommand() : Command("probe") {
    description(
        "Print every intermediate at one pixel of one frame, or how their values are spread over a region");
    addShotOptions(*this, shot);
    addFrame(*this, frame);
    addPixel(*this, pixel);
    add_option("--find", find,
               "In place of --pixel: the worst pixel whose history is rejected, the one whose history is "
               "moved farthest (clipped), or the first one that is NaN or infinite in the output (nan)")
        ->check(CLI::IsMember(kFindSteps));
    add_option("--where", where,
               "In place of --pixel: how much each pixel moves with this number of the settings, as path "
               "(neighborhood.gamma): in how many, how much, and where most");
    add_option("--picture", picture,
               "Of --where: a PNG of it, darker over gray to brighter, to the change that 99 of 100 of the "
               "pixels that move do not exceed");
    addForce(*this, force);
    add_option("--region", region,
               "X,Y,WxH in place of --pixel: least and greatest value, mean, deviation, percentiles and "
               "histogram of each row there, and how many are NaN, infinite or absent");
    add_option("--emit", emit,
               "Of a region: intermediates, with commas between (see list intermediates), or all; else those "
               "of the frame's own resolve")
        ->delimiter(',')
        ->allow_extra_args(false);
    addReferenceSamples(*this, referenceSamples,
                        "of the reference, where --emit names rows of it, 4 to 1024");
    addJson(*this, json);
    add_flag("--what-if", whatIf,
             "Also print the pixel under every rectification, box, history filter and preset");
    add_flag("--sensitivity", sensitivity,
             "Also print how much the pixel moves with each sample, each texel of history and each number of "
             "the settings: exact derivatives of the resolve, on the history it had");
    add_option("--formulas", formulas,
               "What formulas are written down to: rows, one line each; stage, the rows of other stages; "
               "samples, the texels and settings that were read")
        ->check(CLI::IsMember(kDepths));
    add_option(
        "--compare", compare,
        "Also print each row of what the pixel is compared with, and their difference: preset:NAME, frame:N, "
        "frame:-N for N frames before, or motion:-1 for the frame before, where the pixel came from");
  }

  int run(std::ostream& out, const Progress& progress) const override;
  void checkPlace() const;
  Comparison comparison(const ShotPlan& plan) const;
  std::vector<IntermediateId> rows() const;
  void printMap(const ShotPlan& plan, Inspector& inspector, std::ostream& out,
                const Progress& progress) const;
  void printRegion(const RegionRequest& request, const ShotPlan& plan, Inspector& inspector,
                   std::ostream& out, const Progress& progress) const;
};

/// What is asked for in place of a pixel is one thing, and what belongs to a pixel is said of one.
void ProbeCommand::checkPlace() const {
  const int places = !pixel.empty() + !find.empty() + !region.empty() + !where.empty();
  if (places != 1)
    throw UsageError("one of --pixel, --find, --region and --where is required; taa-batch probe --help says "
                     "what they are");
  if (!(region.empty() && where.empty()) && (whatIf || sensitivity || !compare.empty()))
    throw UsageError(
        "--what-if, --sensitivity and --compare are of a pixel, not of a region or of the picture");
  if (where.empty() && !picture.empty()) throw UsageError("--picture is of --where");
  if (!where.empty()) readOption("--where", [&] { return &parameter(where); });
  if (region.empty() && !emit.empty())
    throw UsageError("--emit is of a region: probe prints all rows of a pixel");
}

Comparison ProbeCommand::comparison(const ShotPlan& plan) const {
  if (compare.empty()) return {};
  const Comparison parsed = readOption("--compare", [&] { return parseComparison(compare); });
  if (parsed.kind == OtherKind::Row)
    throw UsageError("--compare: probe prints all rows already: name a preset or a frame");
  if (parsed.kind == OtherKind::Preset && plan.lanes.size() > 1)
    throw UsageError("--compare is of one lane: leave --lane out");
  return parsed;
}

/// Of a region.
std::vector<IntermediateId> ProbeCommand::rows() const {
  if (!emit.empty()) return parseEmit(emit);
  std::vector<IntermediateId> ids;
  for (const Intermediate& row : kIntermediates)
    if (!isOfReference(row.id)) ids.push_back(row.id);
  return ids;
}

void printWhatIf(std::ostream& out, const std::vector<WhatIfRow>& variants) {
  std::vector<std::vector<std::string>> rows{
      {"", "", "resolved R", "G", "B", "difference R", "G", "B", "alpha", ""}};
  for (const WhatIfRow& row : variants) {
    const bool isFirst = &row == variants.data() || (&row - 1)->group != row.group;
    std::vector<std::string> cells{std::string(isFirst ? whatIfGroupLabel(row.group) : ""),
                                   (row.isCurrent ? "* " : "  ") + row.label};
    for (const glm::vec3& color : {row.resolved, row.difference})
      for (int channel = 0; channel < 3; ++channel) cells.push_back(shortestText(color[channel]));
    cells.push_back(shortestText(row.alpha));
    cells.push_back(row.rejectReason == 0 ? row.note
                                          : std::string(rejectReasonText(row.rejectReason)) +
                                                (row.note.empty() ? "" : "; " + row.note));
    rows.push_back(std::move(cells));
  }
  out << "What if\n";
  printTable(out, rows, "  ");
}

void printSensitivities(std::ostream& out, const std::vector<Sensitivity>& all) {
  std::vector<std::vector<std::string>> rows{{"", "", "luma by that step", "d R", "d G", "d B", ""}};
  for (const Sensitivity& each : all) {
    const bool isFirst = &each == all.data() || (&each - 1)->to != each.to;
    rows.push_back({std::string(isFirst ? sensitivityLabel(each.to) : ""), sensitivityText(each),
                    significantText(each.lumaChange(), 3), significantText(each.slope.x, 4),
                    significantText(each.slope.y, 4), significantText(each.slope.z, 4),
                    each.isOneSided ? "one-sided" : ""});
  }
  out << "Sensitivity\n";
  printTable(out, rows, "  ");
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

gl::Rect regionOf(const std::string& text) {
  const std::optional<gl::Rect> region = parseRegion(text);
  if (!region)
    throw UsageError("--region " + text + ": expected X,Y,WxH, for example 40,20,64x36; 0,0 is the top left");
  return *region;
}

glm::ivec2 foundPixel(Inspector& inspector, const std::string& find) {
  const WorstStep step =
      std::ranges::find(kFindSteps, find, &decltype(kFindSteps)::value_type::first)->second;
  return inspector.worst().next(IntermediateId::resolved, 0, {}, step).worst.pixel;
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

void ProbeCommand::printRegion(const RegionRequest& request, const ShotPlan& plan, Inspector& inspector,
                               std::ostream& out, const Progress& progress) const {
  const InspectedShot& opened = inspector.shot();
  const gl::Rect inside = *insidePicture(request.rect, opened.width(), opened.height());
  nlohmann::ordered_json result = shotJson(inspector);
  result["frame"] = opened.frame();
  result["region"] = {inside.x, inside.y, inside.width, inside.height};
  for (int lane = 0; lane < opened.laneCount(); ++lane) {
    inspector.reference().makeRows(request.rows, referenceSamples, progress, lane);
    const SpaceSettings& space = opened.usedSettings(lane).space;
    std::vector<RegionSpread> spreads;
    nlohmann::ordered_json ofLane = laneJson(inspector, plan, lane);
    for (const IntermediateId id : request.rows) {
      const Intermediate& row = intermediate(id);
      spreads.push_back(regionSpread(inspector.views().image(id, lane, inside), {}, row, inside));
      ofLane["rows"][std::string(row.name)] = spreadJson(spreads.back(), row, space);
    }
    result["lanes"].push_back(std::move(ofLane));
    if (json) continue;
    out << laneHeading(plan, lane) << "region " << regionPlaceText(inside) << " of frame " << opened.frame()
        << '\n';
    printSpreads(out, spreads, request.rows, space);
  }
  if (json) print(out, result);
}

void ProbeCommand::printMap(const ShotPlan& plan, Inspector& inspector, std::ostream& out,
                            const Progress& progress) const {
  const SensitivityMap map =
      readOption("--where", [&] { return inspector.probes().sensitivityMap(where, progress); });
  const float range = mappedRange(map);
  if (!picture.empty()) {
    const Picture drawn = mapPicture(map, range);
    writePng(picture, drawn.width, drawn.height, drawn.rgba);
  }
  if (!json) {
    out << laneHeading(plan, 0) << sensitivityMapText(map) << '\n';
    return;
  }
  nlohmann::ordered_json result = shotJson(inspector);
  result["frame"] = inspector.shot().frame();
  result["where"] = {{"path", map.number.path},
                     {"value", map.number.value},
                     {"step", map.number.step()},
                     {"share", map.share},
                     {"meanLuma", map.mean},
                     {"largestLuma", map.largest},
                     {"largestAt", {map.largestAt.x, map.largestAt.y}},
                     {"range", range}};
  print(out, result);
}

int ProbeCommand::run(std::ostream& out, const Progress& progress) const {
  ShotPlan plan = planShot(shot);
  const Comparison other = comparison(plan);
  const auto laneCount = static_cast<int>(plan.lanes.size());
  if (other.kind == OtherKind::Preset) plan.lanes.push_back(laneOfPreset("other", other.preset));
  checkPlace();
  if (!picture.empty() && !force) refuseToReplace({picture});
  if (!where.empty() && laneCount > 1) throw UsageError("--where is of one lane: leave --lane out");
  std::optional<glm::ivec2> place;
  if (!pixel.empty()) place = parsePixel(pixel);
  std::optional<RegionRequest> request;
  if (!region.empty()) request = {regionOf(region), rows()};
  checkReferenceSamples(referenceSamples);
  const int shown = frameOf(plan, frame);
  Inspector inspector;
  openShot(inspector, plan, progress);
  requireFrame(inspector, plan, shown);
  if (place) requirePixel(inspector, *place);
  if (request) {
    requirePixel(inspector, {request->rect.x, request->rect.y});
    std::vector<IntermediateId> resolved = request->rows;
    std::erase_if(resolved, isOfReference);
    inspector.views().watch(resolved); // exposed in one run
  }
  inspector.shot().seek(shown, progress);
  if (request) {
    printRegion(*request, plan, inspector, out, progress);
    return kDone;
  }
  if (!where.empty()) {
    printMap(plan, inspector, out, progress);
    return kDone;
  }
  const glm::ivec2 at = place ? *place : foundPixel(inspector, find);

  ProbeReport report{shotFacts(inspector), at, {}, other};
  for (int lane = 0; lane < laneCount; ++lane) {
    ProbedLane probed{laneFacts(inspector, plan, lane), inspector.probes().probe(at.x, at.y, lane)};
    probed.details = std::make_shared<twin::Details>(inspector.probes().details(at.x, at.y, lane));
    if (whatIf) probed.whatIf = inspector.probes().whatIf(at.x, at.y, lane);
    if (sensitivity) probed.sensitivities = inspector.probes().sensitivities(at.x, at.y, lane);
    probed.depth = std::ranges::find(kDepths, formulas, &decltype(kDepths)::value_type::first)->second;
    addOtherSide(inspector, other, at, lane, probed, progress);
    report.lanes.push_back(std::move(probed));
  }
  if (json) {
    print(out, probeJson(report));
    return kDone;
  }
  for (int lane = 0; lane < laneCount; ++lane) {
    const ProbedLane& probed = report.lanes[static_cast<std::size_t>(lane)];
    out << laneHeading(plan, lane);
    if (probed.compared) out << comparedText(other, *probed.compared) << '\n';
    out << probeTable(probed, at);
    if (!probed.whatIf.empty()) printWhatIf(out, probed.whatIf);
    if (sensitivity) printSensitivities(out, probed.sensitivities);
  }
  return kDone;
}

} // namespace

std::shared_ptr<Command> probeCommand() {
  return std::make_shared<ProbeCommand>();
}

} // namespace taa::cli
