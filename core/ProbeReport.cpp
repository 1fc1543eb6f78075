#include "core/ProbeReport.h"

#include "core/base/Say.h"
#include "core/io/FrameJson.h"

#include <array>

namespace taa {

using nlohmann::ordered_json;

namespace {

std::string valuesText(const Intermediate& row, const glm::vec4& value, const char* between) {
  std::string text;
  for (int channel = 0; channel < row.channels; ++channel)
    text += (channel > 0 ? between : "") + floatText(value[channel]);
  if (row.id == IntermediateId::rejectReason)
    text += " (" + std::string(rejectReasonText(static_cast<int>(value.x))) + ")";
  return text;
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

std::string placeText(const ProbeReport& report, const LaneFacts& lane) {
  return say<"pixel %1 %2 frame %3 of %4, camera %5, %6x%7, preset %8">(
      report.pixel.x, report.pixel.y, lane.info.frame, report.shot.source, report.shot.camera,
      report.shot.width, report.shot.height, lane.preset);
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

ordered_json probeJson(const ProbeReport& report) {
  ordered_json json = shotJson(report.shot);
  json["frame"] = report.lanes.front().lane.info.frame;
  json["time"] = report.lanes.front().lane.info.time;
  json["pixel"] = {report.pixel.x, report.pixel.y};
  for (const ProbedLane& lane : report.lanes) {
    ordered_json row = laneJson(lane.lane);
    row["values"] = recordJson(lane.record);
    for (const WhatIfRow& variant : lane.whatIf) row["whatIf"].push_back(whatIfJson(variant));
    json["lanes"].push_back(row);
  }
  return json;
}

std::string probeText(const ProbeReport& report) {
  std::string text;
  for (const ProbedLane& lane : report.lanes) {
    text += (text.empty() ? "" : "\n") + placeText(report, lane.lane) + "\n";
    forEachRow([&](const StageInfo&, const Intermediate& row, bool) {
      text += std::string(row.name) + " " + valuesText(row, reference::at(lane.record, row.id), " ");
      if (!row.unit.empty()) text += " " + std::string(row.unit);
      text += "\n";
    });
  }
  return text;
}

std::string probeMarkdown(const ProbeReport& report) {
  std::string text;
  for (const ProbedLane& lane : report.lanes) {
    text += (text.empty() ? "" : "\n") + say<"Probe: %1">(placeText(report, lane.lane)) +
            "\n\n| Stage | Intermediate | Value | Unit |\n|---|---|---|---|\n";
    forEachRow([&](const StageInfo& stage, const Intermediate& row, bool isFirst) {
      text += "| " + std::string(isFirst ? stage.label : "") + " | " + std::string(row.label) + " | " +
              valuesText(row, reference::at(lane.record, row.id), ", ") + " | " + std::string(row.unit) +
              " |\n";
    });
  }
  return text;
}

} // namespace taa
