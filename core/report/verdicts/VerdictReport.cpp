#include "core/report/verdicts/VerdictReport.h"

#include "core/inspect/verdicts/RemedyTrial.h"
#include "core/io/FrameJson.h"
#include "core/verdict/parts/PartsRows.h"
#include "core/verdict/pixel/VerdictText.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string_view>

namespace taa {

using nlohmann::ordered_json;

namespace {

ordered_json numberJson(double value) {
  return floatJson(static_cast<float>(value));
}

std::string shortNumber(double value) {
  return floatText(static_cast<float>(value));
}

ordered_json channelsJson(const glm::dvec3& color) {
  return {numberJson(color.x), numberJson(color.y), numberJson(color.z)};
}

std::string_view rowNameOf(ErrorPart part) {
  return intermediate(rowOfPart(part)).name;
}

ordered_json splitJson(const ErrorSplit& split) {
  ordered_json json = ordered_json::object();
  for (std::size_t part = 0; part < kErrorParts; ++part)
    json[std::string(rowNameOf(static_cast<ErrorPart>(part)))] = channelsJson(split[part]);
  return json;
}

ordered_json rowJson(const VerdictRow& row) {
  ordered_json json{{"id", intermediate(row.id).name},
                    {"frame", row.frame},
                    {"pixel", {row.pixel.x, row.pixel.y}},
                    {"value", numberJson(row.value)}};
  if (row.limit) json["limit"] = numberJson(*row.limit);
  return json;
}

ordered_json pixelMeasureJson(const RemedyMeasure& pixel) {
  return {{"error", numberJson(pixel.error)}, {"errorChange", numberJson(pixel.errorChange)}};
}

ordered_json pictureMeasureJson(const std::optional<RemedyMeasure>& picture) {
  if (!picture) return {};
  return {{"error", numberJson(picture->error)},
          {"flicker", numberJson(picture->flicker)},
          {"ghost", numberJson(picture->ghost)},
          {"sharpness", numberJson(picture->sharpness)}};
}

ordered_json remediesJson(const RemedyAnswer& remedies) {
  ordered_json json{{"firstFrame", remedies.first},
                    {"tried", remedies.tried},
                    {"pixel", pixelMeasureJson(remedies.pixel)},
                    {"picture", pictureMeasureJson(remedies.picture)},
                    {"best", ordered_json::array()}};
  for (const TriedRemedy& tried : remedies.best)
    json["best"].push_back({{"changes", tried.remedy.changes},
                            {"pixel", pixelMeasureJson(tried.pixel)},
                            {"picture", pictureMeasureJson(tried.picture)}});
  return json;
}

ordered_json laneValues(const VerdictOfLane& lane) {
  const PixelVerdict& verdict = lane.answer.verdict;
  ordered_json json{
      {"sentence", lane.answer.sentence},
      {"kind", kVerdictKinds[static_cast<std::size_t>(verdict.kind)].id},
      {"stage", verdict.kind == VerdictKind::None ? ordered_json() : stageInfo(verdict.stage).id},
      {"throwsGoodHistoryAway", verdict.throwsGoodAway},
      {"error", numberJson(verdict.error)},
      {"flicker", numberJson(verdict.flicker)},
      {"part", rowNameOf(verdict.part)},
      {"share", numberJson(verdict.share)},
      {"since", verdict.since},
      {"causeFrame", verdict.causeFrame},
      {"causeObject", verdict.causeObject ? ordered_json(*verdict.causeObject) : ordered_json()},
      {"causeName", lane.answer.object},
      {"resolved", channelsJson(lane.answer.error.resolved)},
      {"reference", channelsJson(lane.answer.error.reference)},
      {"parts", splitJson(lane.answer.error.sum)},
      {"rows", ordered_json::array()},
      {"frames", ordered_json::array()},
      {"strays", ordered_json::array()}};
  for (const VerdictRow& row : verdict.rows) json["rows"].push_back(rowJson(row));
  for (const ErrorOfFrame& entry : lane.answer.error.frames)
    json["frames"].push_back(
        {{"frame", entry.frame}, {"weight", numberJson(entry.weight)}, {"parts", splitJson(entry.split)}});
  for (const StraySamples& stray : lane.answer.error.strays)
    json["strays"].push_back({{"frame", stray.frame},
                              {"object", stray.object},
                              {"pull", channelsJson(stray.pull)},
                              {"weight", numberJson(stray.weight)}});
  if (lane.remedies) json["remedies"] = remediesJson(*lane.remedies);
  return json;
}

std::string changesText(const std::vector<std::string>& changes) {
  std::string text;
  for (const std::string& change : changes) text += (text.empty() ? "" : " ") + change;
  return text;
}

std::string measureText(const RemedyMeasure& pixel, const std::optional<RemedyMeasure>& picture) {
  const std::string text =
      "pixel: error " + shortNumber(pixel.error) + ", its change " + shortNumber(pixel.errorChange);
  if (!picture) return text;
  return text + "; picture: error " + shortNumber(picture->error) + ", flicker " +
         shortNumber(picture->flicker) + ", ghost " + shortNumber(picture->ghost) + ", sharpness " +
         shortNumber(picture->sharpness);
}

} // namespace

ordered_json verdictJson(const VerdictReport& report) {
  ordered_json json = shotJson(report.shot);
  json["frame"] = report.frame;
  json["pixel"] = {report.pixel.x, report.pixel.y};
  json["referenceSamples"] = report.samples;
  for (const VerdictOfLane& lane : report.lanes) {
    ordered_json row = laneJson(lane.lane);
    row.update(laneValues(lane));
    json["lanes"].push_back(row);
  }
  return json;
}

std::string verdictText(const VerdictOfLane& lane) {
  const PixelVerdict& verdict = lane.answer.verdict;
  std::string text = lane.answer.sentence + '\n';
  if (verdict.kind != VerdictKind::None) text += verdictMeasures(verdict) + '\n';
  text += "Because of\n";
  for (const VerdictRow& row : verdict.rows) {
    text += "  " + std::string(intermediate(row.id).name) + " " + shortNumber(row.value);
    if (row.limit) text += " against " + shortNumber(*row.limit);
    text += " in frame " + std::to_string(row.frame) + " at " + std::to_string(row.pixel.x) + "," +
            std::to_string(row.pixel.y) + '\n';
  }
  text += "Parts of the error (red, green, blue)\n";
  for (std::size_t part = 0; part < kErrorParts; ++part) {
    const glm::dvec3& value = lane.answer.error.sum[part];
    text += "  " + std::string(rowNameOf(static_cast<ErrorPart>(part))) + " " + shortNumber(value.x) + " " +
            shortNumber(value.y) + " " + shortNumber(value.z) + '\n';
  }
  if (!lane.remedies) return text;
  text += "Remedies, of " + std::to_string(lane.remedies->tried) + " tried from frame " +
          std::to_string(lane.remedies->first) + ", measured over the last " +
          std::to_string(kMeasuredFrames) +
          " frames\n  as it is: " + measureText(lane.remedies->pixel, lane.remedies->picture) + '\n';
  for (const TriedRemedy& tried : lane.remedies->best)
    text += "  " + changesText(tried.remedy.changes) + ": " + measureText(tried.pixel, tried.picture) + '\n';
  if (lane.remedies->best.empty())
    text += "  none of them brings the pixel clearly nearer to the reference\n";
  return text;
}

} // namespace taa
