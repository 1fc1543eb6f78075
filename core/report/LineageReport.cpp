#include "core/report/LineageReport.h"

#include "core/base/NumberText.h"
#include "core/io/FrameJson.h"
#include "core/verdict/lineage/LineageWords.h"

#include <nlohmann/json.hpp>

namespace taa {

using nlohmann::ordered_json;

namespace {

ordered_json realJson(double value) {
  return floatJson(static_cast<float>(value));
}

std::string realText(double value) {
  return shortestText(static_cast<float>(value));
}

ordered_json vectorJson(const glm::dvec2& vector) {
  return {realJson(vector.x), realJson(vector.y)};
}

ordered_json vectorJson(const glm::dvec3& vector) {
  return {realJson(vector.x), realJson(vector.y), realJson(vector.z)};
}

ordered_json frameJson(const LineageFrame& entry) {
  return {{"frame", entry.frame},
          {"weight", realJson(entry.weight)},
          {"channels", vectorJson(entry.channels)},
          {"rectified", realJson(entry.rectified)},
          {"color", vectorJson(entry.color)},
          {"own", vectorJson(entry.own)},
          {"place", vectorJson(entry.place)},
          {"spreadPx", realJson(entry.spreadPx)},
          {"pixels", entry.pixels},
          {"object", entry.object}};
}

ordered_json sampleJson(const FootprintSample& sample) {
  return {{"frame", sample.frame},
          {"texel", {sample.texel.x, sample.texel.y}},
          {"offset", vectorJson(sample.offset)},
          {"weight", realJson(sample.weight)}};
}

ordered_json valuesJson(const Lineage& lineage) {
  ordered_json json = {{"headline", lineageSentences(lineage)},
                       {"weight", realJson(lineage.weight)},
                       {"rectified", realJson(lineage.rectified)},
                       {"older", realJson(lineage.older)},
                       {"pruned", realJson(lineage.pruned)},
                       {"blank", realJson(lineage.blank)},
                       {"rest", vectorJson(lineage.rest)},
                       {"resolved", vectorJson(lineage.resolved)},
                       {"historyLength", realJson(lineage.historyLength)},
                       {"effectiveFrames", realJson(lineage.effectiveFrames)},
                       {"effectiveSamples", realJson(lineage.effectiveSamples)},
                       {"variance", realJson(lineage.variance)},
                       {"radiusPx", realJson(lineage.radiusPx)}};
  for (const LineageFrame& entry : lineage.frames) json["frames"].push_back(frameJson(entry));
  for (const FootprintSample& sample : lineage.samples) json["samples"].push_back(sampleJson(sample));
  return json;
}

} // namespace

ordered_json lineageJson(const LineageReport& report) {
  ordered_json json = shotJson(report.shot);
  json["frame"] = report.lanes.front().lineage.frame;
  json["pixel"] = {report.pixel.x, report.pixel.y};
  for (const LineageOfLane& lane : report.lanes) {
    ordered_json row = laneJson(lane.lane);
    row.update(valuesJson(lane.lineage));
    json["lanes"].push_back(row);
  }
  return json;
}

std::vector<std::vector<std::string>> lineageTable(const Lineage& lineage) {
  std::vector<std::vector<std::string>> rows{
      {"FRAME", "WEIGHT", "RECTIFIED", "X", "Y", "SPREAD PX", "PIXELS", "OBJECT"}};
  for (const LineageFrame& entry : lineage.frames)
    rows.push_back({std::to_string(entry.frame), realText(entry.weight), realText(entry.rectified),
                    realText(entry.place.x), realText(entry.place.y), realText(entry.spreadPx),
                    std::to_string(entry.pixels), std::to_string(entry.object)});
  rows.push_back({"all", realText(lineage.weight), realText(lineage.rectified)});
  rows.push_back({"older", realText(lineage.older)});
  rows.push_back({"pruned", realText(lineage.pruned)});
  rows.push_back({"blank", realText(lineage.blank)});
  return rows;
}

} // namespace taa
