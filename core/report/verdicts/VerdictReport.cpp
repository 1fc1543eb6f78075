#include "core/report/verdicts/VerdictReport.h"

#include "core/base/NumberText.h"
#include "core/explanation/RowFormatter.h"
#include "core/inspect/RemedyTrial.h"
#include "core/io/FrameJson.h"
#include "core/verdict/parts/PartsRows.h"
#include "core/verdict/pixel/BlindAgreement.h"
#include "core/verdict/pixel/VerdictText.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace taa {

using nlohmann::ordered_json;

namespace {

ordered_json numberJson(double value) {
  return floatJson(static_cast<float>(value));
}

/// What JSON has no number for is text: "inf".
ordered_json decibelJson(double value) {
  return std::isinf(value) ? ordered_json("inf") : numberJson(value);
}

std::string partText(double value) {
  return shortestText(static_cast<float>(value));
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
  return {{"error", numberJson(pixel.error)},
          {"latest", numberJson(pixel.latest)},
          {"errorChange", numberJson(pixel.errorChange)}};
}

ordered_json pictureMeasureJson(const std::optional<RemedyMeasure>& picture) {
  if (!picture) return {};
  return {{"error", numberJson(picture->error)},
          {"psnr", decibelJson(psnrOf(*picture))},
          {"flicker", numberJson(picture->flicker)},
          {"ghost", numberJson(picture->ghost)},
          {"sharpness", numberJson(picture->sharpness)}};
}

ordered_json remediesJson(const RemedyAnswer& remedies) {
  ordered_json json{{"firstFrame", remedies.first},
                    {"tried", remedies.tried},
                    {"referenceSamples", remedies.samples},
                    {"pixel", pixelMeasureJson(remedies.pixel)},
                    {"picture", pictureMeasureJson(remedies.picture)},
                    {"best", ordered_json::array()}};
  for (const TriedRemedy& tried : remedies.best)
    json["best"].push_back({{"changes", tried.remedy.changes},
                            {"named", tried.isNamed},
                            {"mends", isCorrection(remedies.pixel, tried.pixel)},
                            {"costsPicture", remedies.picture && tried.picture &&
                                                 costsPicture(*remedies.picture, *tried.picture)},
                            {"pixel", pixelMeasureJson(tried.pixel)},
                            {"picture", pictureMeasureJson(tried.picture)}});
  return json;
}

ordered_json agreementJson(VerdictKind kind) {
  const BlindAgreement agreement = blindAgreement(kind);
  return {{"named", agreement.named}, {"right", agreement.right}};
}

ordered_json laneValues(const VerdictOfLane& lane) {
  const PixelVerdict& verdict = lane.answer.verdict;
  ordered_json json{
      {"sentence", lane.answer.sentence},
      {"kind", kVerdictKinds[static_cast<std::size_t>(verdict.kind)].id},
      {"stage", verdict.kind == VerdictKind::None ? ordered_json() : stageInfo(verdict.stage).id},
      {"checkedBlind", agreementJson(verdict.kind)},
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
      {"referenceSamples", lane.answer.samples},
      {"referenceError",
       lane.answer.referenceError ? numberJson(*lane.answer.referenceError) : ordered_json()},
      {"parts", splitJson(lane.answer.error.sum)},
      {"rows", ordered_json::array()},
      {"frames", ordered_json::array()},
      {"strays", ordered_json::array()}};
  for (const VerdictRow& row : verdict.rows) json["rows"].push_back(rowJson(row));
  for (const ErrorOfFrame& entry : lane.answer.error.frames)
    json["frames"].push_back(
        {{"frame", entry.frame}, {"weight", numberJson(entry.weight)}, {"parts", splitJson(entry.split)}});
  for (const OutlierSamples& outlier : lane.answer.error.outliers)
    json["strays"].push_back({{"frame", outlier.frame},
                              {"object", outlier.object},
                              {"pull", channelsJson(outlier.pull)},
                              {"weight", numberJson(outlier.weight)}});
  if (lane.remedies) json["remedies"] = remediesJson(*lane.remedies);
  return json;
}

std::string changesText(const std::vector<std::string>& changes) {
  std::string text;
  for (const std::string& change : changes) text += (text.empty() ? "" : " ") + change;
  return text;
}

std::string stepsChange(double before, double after) {
  return numberText(255.0 * before, 3) + " → " + numberText(255.0 * after, 3);
}

std::string pictureChange(const RemedyMeasure& before, const RemedyMeasure& after) {
  return "picture: PSNR " + numberText(psnrOf(before), 4) + " → " + numberText(psnrOf(after), 4) +
         " dB, flicker " + stepsChange(before.flicker, after.flicker) + ", ghost " +
         stepsChange(before.ghost, after.ghost) + ", sharpness " +
         explanation::percentText(before.sharpness) + " → " + explanation::percentText(after.sharpness);
}

/// Before → after, of 255 steps where nothing else is said.
std::string remedyText(const RemedyAnswer& remedies, const TriedRemedy& tried) {
  std::string text = "  " + changesText(tried.remedy.changes) + "\n    pixel: error " +
                     stepsChange(remedies.pixel.error, tried.pixel.error) + ", in this frame " +
                     stepsChange(remedies.pixel.latest, tried.pixel.latest) + ", change per frame " +
                     stepsChange(remedies.pixel.errorChange, tried.pixel.errorChange) + '\n';
  if (remedies.picture && tried.picture)
    text += "    " + pictureChange(*remedies.picture, *tried.picture) + '\n';
  const std::string note = remedyNote(tried, remedies.pixel, remedies.picture);
  return note.empty() ? text : text + "    " + note + '\n';
}

std::string remediesText(const RemedyAnswer& remedies) {
  if (remedies.tried == 0) return "No remedy was tried: nothing is wrong.\n";
  std::string text = "Remedies: " + std::to_string(remedies.tried) + " changes tried from frame " +
                     std::to_string(remedies.first) + ", measured over the last " +
                     std::to_string(kMeasuredFrames) + " frames, in steps of 255\n";
  for (const TriedRemedy& tried : remedies.best) text += remedyText(remedies, tried);
  const auto corrects = [&](const TriedRemedy& tried) { return isCorrection(remedies.pixel, tried.pixel); };
  if (std::ranges::none_of(remedies.best, corrects))
    text += "  None of them brings the pixel clearly nearer to the reference.\n";
  return text;
}

std::string referenceText(const VerdictAnswer& answer) {
  if (!answer.referenceError) return "Reference: it came with the capture.\n";
  return "Reference: " + std::to_string(answer.samples) + " samples, ± " +
         numberText(255.0 * *answer.referenceError, 2) + "/255 here.\n";
}

/// "dilatedMotion (-18.2, 0) px in frame 30 at 591,240; the limit is 3"
std::string evidenceText(const VerdictRow& row) {
  const Intermediate& of = intermediate(row.id);
  std::string values = numberText(row.value);
  if (of.channels > 1) {
    for (int channel = 1; channel < of.channels; ++channel)
      values += ", " + numberText(static_cast<double>(row.channels[channel]));
    values = "(" + values + ")";
  }
  std::string text = std::string(of.name) + " " + values;
  if (!of.unit.empty()) text += " " + std::string(of.unit);
  text += " in frame " + std::to_string(row.frame) + " at " + std::to_string(row.pixel.x) + "," +
          std::to_string(row.pixel.y);
  if (row.limit) text += "; the limit is " + numberText(*row.limit);
  return text;
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
  text += referenceText(lane.answer) + agreementText(verdict.kind) + '\n';
  if (verdict.kind != VerdictKind::None)
    text += "Stage: " + std::string(stageInfo(verdict.stage).label) + '\n';
  text += "Evidence\n";
  for (const VerdictRow& row : verdict.rows) text += "  " + evidenceText(row) + '\n';
  text += "Parts of the error (red, green, blue)\n";
  for (std::size_t part = 0; part < kErrorParts; ++part) {
    const glm::dvec3& value = lane.answer.error.sum[part];
    text += "  " + std::string(rowNameOf(static_cast<ErrorPart>(part))) + " " + partText(value.x) + " " +
            partText(value.y) + " " + partText(value.z) + '\n';
  }
  if (!lane.remedies) return text;
  return text + remediesText(*lane.remedies);
}

} // namespace taa
