#include "core/report/ProbeReport.h"

#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/explanation/ProbeHeadline.h"
#include "core/io/FrameJson.h"
#include "core/taa/ChannelNames.h"
#include "core/taa/twin/Known.h"

#include <array>
#include <string_view>

namespace taa {

using nlohmann::ordered_json;

namespace {

std::string valuesText(const Intermediate& row, const twin::PixelRecord& record, const char* between) {
  if (!twin::isKnown(record, row.id)) return "—";
  const glm::vec4& value = twin::at(record, row.id);
  std::string text;
  for (int channel = 0; channel < row.channels; ++channel)
    text += (channel > 0 ? between : "") + shortestText(value[channel]);
  if (const std::string_view category = categoryText(row.id, static_cast<int>(value.x)); !category.empty())
    text += " (" + std::string(category) + ")";
  return text;
}

std::string numbersText(const Intermediate& row, const glm::vec4& value) {
  std::string text;
  for (int channel = 0; channel < row.channels; ++channel)
    text += (channel > 0 ? " " : "") + shortestText(value[channel]);
  return text;
}

ordered_json numbersJson(const Intermediate& row, const PartialValue& value, const SpaceSettings& space) {
  ordered_json json;
  int channel = 0;
  for (const std::string& name : channelNames(row, space))
    if (value.absence == Absence::None) json[name] = floatJson(value.value[channel++]);
  return json;
}

/// {"with": "motion:-1", "frame": 6, "position": [12.5, 3.5], "rows": {"color": {"other": …, "difference":
/// …}, …}}; both are null where there is no difference, and "absence" says why.
ordered_json comparedJson(const Comparison& comparison, const ProbedLane& lane) {
  const ComparedPixel& compared = *lane.compared;
  ordered_json json = {{"with", comparisonText(comparison)}, {"frame", compared.frame}};
  if (compared.position)
    json["position"] = {floatJson(compared.position->x), floatJson(compared.position->y)};
  for (const Intermediate& row : kIntermediates) {
    const SpaceSettings& space = lane.lane.settings.space;
    const PartialValue difference = differenceOf(lane.record, compared, row.id);
    ordered_json& told = json["rows"][std::string(row.name)];
    told = {{"other", numbersJson(row, compared.of(row.id), space)},
            {"difference", numbersJson(row, difference, space)}};
    if (difference.absence != Absence::None) told["absence"] = absenceText(difference.absence);
  }
  return json;
}

ordered_json colorJson(const glm::vec3& color) {
  return {{"R", floatJson(color.x)}, {"G", floatJson(color.y)}, {"B", floatJson(color.z)}};
}

ordered_json whatIfJson(const WhatIfRow& row) {
  ordered_json json = {{"group", whatIfGroupLabel(row.group)},
                       {"id", row.id},
                       {"current", row.isCurrent},
                       {"historyRectified", colorJson(row.historyRectified)},
                       {"alpha", floatJson(row.alpha)},
                       {"rejectReason", row.rejectReason},
                       {"resolved", colorJson(row.resolved)},
                       {"difference", colorJson(row.difference)}};
  if (!row.note.empty()) json["note"] = row.note;
  return json;
}

ordered_json colorJson(const glm::dvec3& color) {
  return {{"R", color.x}, {"G", color.y}, {"B", color.z}};
}

ordered_json sensitivityJson(const Sensitivity& each) {
  ordered_json json;
  if (each.to == SensitivityTo::Parameter) {
    json = {{"parameter", each.path}, {"value", each.value}};
  } else {
    json = {{each.to == SensitivityTo::Sample ? "sample" : "history", {each.texel.x, each.texel.y}},
            {"offset", {each.offset.x, each.offset.y}}};
  }
  json["slope"] = colorJson(each.slope);
  json["step"] = each.step();
  json["lumaChange"] = each.lumaChange();
  json["oneSided"] = each.isOneSided;
  return json;
}

/// Bars would end the cell.
std::string inMarkdown(const std::string& text) {
  std::string escaped;
  for (const char letter : text) escaped += letter == '|' ? std::string("\\|") : std::string(1, letter);
  return escaped;
}

std::string bulletList(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += "- " + line + "\n";
  return text;
}

/// What the window tells of a row; nothing without details.
RowExplanation laneExplanation(const ProbedLane& lane, const glm::ivec2& pixel, IntermediateId id) {
  if (!lane.details) return {};
  return taa::explainRow(id, {lane.record, *lane.details, lane.lane.settings, lane.lane.info, pixel},
                         lane.depth);
}

/// "R: half(0.5) = 0.5"
std::string formulaText(const RowExplanation& explanation) {
  return (explanation.subject.empty() ? "" : explanation.subject + ": ") + explanation.formula;
}

/// Words and formula as lines below a row.
std::string explanationLines(const RowExplanation& explanation, const std::string& indent) {
  std::string text;
  for (const std::string& line : {explanation.words, formulaText(explanation), becauseText(explanation)})
    if (!line.empty()) text += indent + line + "\n";
  return text;
}

/// The other side as a line below a row; empty without one.
std::string comparedLine(const ProbedLane& lane, IntermediateId id, const std::string& indent) {
  return lane.compared ? indent + comparedText(lane.record, *lane.compared, id) + "\n" : "";
}

std::vector<std::string> headlineOf(const ProbedLane& lane) {
  return probeHeadline(lane.record, lane.lane.settings, lane.lane.info);
}

ordered_json explanationsJson(const ProbedLane& lane, const glm::ivec2& pixel) {
  ordered_json json;
  for (const Intermediate& row : kIntermediates) {
    const RowExplanation explanation = laneExplanation(lane, pixel, row.id);
    ordered_json& told = json[std::string(row.name)] = {{"words", explanation.words}};
    if (const std::string meaning = meaningOf(row.id, lane.record, lane.lane.settings); !meaning.empty())
      told["meaning"] = meaning;
    if (!explanation.formula.empty()) told["formula"] = explanation.formula;
    if (!explanation.subject.empty()) told["of"] = explanation.subject;
    if (!explanation.because.empty()) told["because"] = explanation.because;
  }
  return json;
}

/// Rows of a stage; `tell` gets each.
template <typename Tell>
void forEachRow(Tell tell) {
  for (const StageInfo& stage : kStages) {
    bool isFirst = true;
    for (const IntermediateId id : allRows()) {
      const Intermediate& row = intermediate(id);
      if (row.stage != stage.stage) continue;
      tell(stage, row, isFirst);
      isFirst = false;
    }
  }
}

} // namespace

ordered_json shotJson(const ShotFacts& shot) {
  return {{"source", shot.source},
          {"camera", shot.camera},
          {"driver", shot.driver},
          {"size", {shot.width, shot.height}}};
}

ordered_json laneJson(const LaneFacts& lane) {
  return {{"name", lane.name},
          {"preset", lane.preset},
          {"settings", toJson(lane.settings)},
          {"jitterIndex", lane.info.jitterIndex},
          {"jitterPx", {floatJson(lane.info.jitterPx.x), floatJson(lane.info.jitterPx.y)}}};
}

std::string placeText(const ShotFacts& shot, const glm::ivec2& pixel, const LaneFacts& lane) {
  return say<"pixel %1 %2 frame %3 of %4, camera %5, %6x%7, preset %8">(
      pixel.x, pixel.y, lane.info.frame, shot.source, shot.camera, shot.width, shot.height, lane.preset);
}

std::string comparedText(const Comparison& comparison, const ComparedPixel& compared) {
  const std::string with = comparisonText(comparison);
  const PartialValue& color = compared.of(IntermediateId::color);
  if (color.absence != Absence::None)
    return say<"compared with %1: nothing, %2">(with, absenceText(color.absence));
  if (!compared.position) return say<"compared with %1: frame %2">(with, compared.frame);
  return say<"compared with %1: frame %2 at %3 %4">(with, compared.frame, shortestText(compared.position->x),
                                                    shortestText(compared.position->y));
}

std::string comparedText(const twin::PixelRecord& now, const ComparedPixel& compared, IntermediateId id) {
  const Intermediate& row = intermediate(id);
  const PartialValue difference = differenceOf(now, compared, id);
  if (difference.absence != Absence::None) return say<"no difference: %1">(absenceText(difference.absence));
  return say<"other %1, difference %2">(numbersText(row, compared.of(id).value),
                                        numbersText(row, difference.value));
}

ordered_json probeJson(const ProbeReport& report) {
  ordered_json json = shotJson(report.shot);
  json["frame"] = report.lanes.front().lane.info.frame;
  json["time"] = report.lanes.front().lane.info.time;
  json["pixel"] = {report.pixel.x, report.pixel.y};
  for (const ProbedLane& lane : report.lanes) {
    ordered_json row = laneJson(lane.lane);
    row["headline"] = headlineOf(lane);
    row["values"] = recordJson(lane.record, lane.lane.settings.space);
    if (lane.details) row["stories"] = explanationsJson(lane, report.pixel);
    if (lane.compared) row["compared"] = comparedJson(report.comparison, lane);
    for (const WhatIfRow& variant : lane.whatIf) row["whatIf"].push_back(whatIfJson(variant));
    for (const Sensitivity& each : lane.sensitivities) row["sensitivity"].push_back(sensitivityJson(each));
    json["lanes"].push_back(row);
  }
  return json;
}

std::string probeText(const ProbeReport& report) {
  std::string text;
  for (const ProbedLane& lane : report.lanes) {
    text += (text.empty() ? "" : "\n") + placeText(report.shot, report.pixel, lane.lane) + "\n";
    for (const std::string& line : headlineOf(lane)) text += line + "\n";
    if (lane.compared) text += comparedText(report.comparison, *lane.compared) + "\n";
    forEachRow([&](const StageInfo&, const Intermediate& row, bool) {
      text += std::string(row.name) + " " + valuesText(row, lane.record, " ");
      if (!row.unit.empty()) text += " " + std::string(row.unit);
      text += "\n" + comparedLine(lane, row.id, "  ");
      text += explanationLines(laneExplanation(lane, report.pixel, row.id), "  ");
    });
  }
  return text;
}

std::string probeTable(const ProbedLane& lane, const glm::ivec2& pixel) {
  std::string text;
  for (const std::string& line : headlineOf(lane)) text += line + "\n";
  for (const StageInfo& stage : kStages) {
    bool isAny = false;
    for (const Intermediate& row : kIntermediates) {
      if (row.stage != stage.stage || (isOfReference(row.id) && !twin::isKnown(lane.record, row.id)))
        continue;
      if (!isAny) text += std::string(stage.label) + "\n";
      isAny = true;
      text += "  " + std::string(row.label) + "  " + valuesText(row, lane.record, "  ");
      if (!row.unit.empty()) text += " " + std::string(row.unit);
      text += "\n" + comparedLine(lane, row.id, "      ");
      text += explanationLines(laneExplanation(lane, pixel, row.id), "      ");
    }
  }
  return text;
}

std::string probeMarkdown(const ProbeReport& report) {
  std::string text;
  for (const ProbedLane& lane : report.lanes) {
    text += (text.empty() ? "" : "\n") + say<"Probe: %1">(placeText(report.shot, report.pixel, lane.lane)) +
            "\n\n" + bulletList(headlineOf(lane)) +
            "\n| Stage | Intermediate | Value | Unit | What happened |\n|---|---|---|---|---|\n";
    forEachRow([&](const StageInfo& stage, const Intermediate& row, bool isFirst) {
      text += "| " + std::string(isFirst ? stage.label : "") + " | " + std::string(row.label) + " | " +
              valuesText(row, lane.record, ", ") + " | " + std::string(row.unit) + " | " +
              inMarkdown(laneExplanation(lane, report.pixel, row.id).words) + " |\n";
    });
  }
  return text;
}

} // namespace taa
