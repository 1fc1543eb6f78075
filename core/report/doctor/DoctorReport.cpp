#include "core/report/doctor/DoctorReport.h"

#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/capture/source/Capture.h"
#include "core/scene/builtin/SceneSource.h"
#include "core/settings/Parameters.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace taa {

using doctor::Diagnosis;
using doctor::RegionPlace;
using doctor::Residual;
using doctor::Undecided;
using nlohmann::ordered_json;

namespace {

constexpr std::size_t kShownRegions = 8;

std::string regionsText(const doctor::Finding& finding) {
  if (finding.isWholePicture) return say<"the whole picture">();
  std::string text;
  for (std::size_t i = 0; i < std::min(finding.regions.size(), kShownRegions); ++i)
    text += (i == 0 ? "" : ", ") + finding.regions[i].name;
  if (finding.regions.size() <= kShownRegions) return text;
  return say<"%1 and %2 more">(text, finding.regions.size() - kShownRegions);
}

std::string residualLine(const Residual& residual, std::size_t width) {
  const std::string value = shortNumber(residual.value);
  std::string line = "      " + value + std::string(width - value.size() + 2, ' ') + residual.text;
  if (residual.isBest) line += "  " + say<"← fits">();
  if (residual.isGiven) line += "  " + say<"← what is stored">();
  return line + "\n";
}

std::string findingText(const doctor::Finding& finding, const doctor::FrameNames& names) {
  std::string text = finding.name;
  text += finding.confidence == doctor::Confidence::Sure ? "" : " (" + say<"likely">() + ")";
  text += finding.isKnown ? " (" + say<"known">() + ")" : "";
  text += ": " + regionsText(finding) + "\n";
  const auto line = [&](const std::string& sentence) { text += "  " + sentence + "\n"; };
  line(say<"Seen as: %1">(finding.symptom));
  line(say<"Change: %1">(finding.change));
  line(say<"Evidence: %1">(finding.reason));
  if (!finding.regions.empty()) {
    const RegionPlace& region = finding.regions.front();
    line(say<"Look at: frame %1, pixel %2, %3">(names.of(region.frame), region.pixel.x, region.pixel.y));
  }
  if (!finding.residuals.empty()) line(finding.measure + ":");
  std::size_t width = 0;
  for (const Residual& residual : finding.residuals)
    width = std::max(width, shortNumber(residual.value).size());
  for (const Residual& residual : finding.residuals) text += residualLine(residual, width);
  return text;
}

std::string undecidedText(const Undecided& undecided) {
  return "  " + undecided.question + ": " + undecided.reason + "." +
         (undecided.capture.empty() ? "" : " " + undecided.capture) + "\n";
}

ordered_json regionJson(const RegionPlace& region, const doctor::FrameNames& names) {
  ordered_json out{{"name", region.name},
                   {"frame", region.frame},
                   {"box", {region.box.x, region.box.y, region.box.z, region.box.w}},
                   {"pixel", {region.pixel.x, region.pixel.y}},
                   {"share", region.share}};
  if (const auto number = names.number(region.frame)) out["number"] = *number;
  return out;
}

ordered_json residualJson(const Residual& residual) {
  return {{"id", residual.id},
          {"text", residual.text},
          {"value", residual.value},
          {"given", residual.isGiven},
          {"best", residual.isBest}};
}

template <typename Item, typename Json>
ordered_json listJson(const std::vector<Item>& items, Json json) {
  ordered_json out = ordered_json::array();
  for (const Item& item : items) out.push_back(json(item));
  return out;
}

ordered_json undecidedJson(const Undecided& undecided) {
  return {{"question", undecided.question},
          {"reason", undecided.reason},
          {"capture", undecided.capture},
          {"misfit", undecided.isMisfit},
          {"faults", listJson(undecided.faults, [](Fault fault) { return faultInfo(fault).id; })}};
}

ordered_json foundJson(const doctor::Finding& finding, const doctor::FrameNames& names) {
  return {{"id", finding.id},
          {"name", finding.name},
          {"sure", finding.confidence == doctor::Confidence::Sure},
          {"known", finding.isKnown},
          {"wholePicture", finding.isWholePicture},
          {"regions",
           listJson(finding.regions, [&](const RegionPlace& region) { return regionJson(region, names); })},
          {"reason", finding.reason},
          {"measure", finding.measure},
          {"residuals", listJson(finding.residuals, residualJson)},
          {"symptom", finding.symptom},
          {"change", finding.change},
          {"mending", finding.correction},
          {"alike", finding.alike}};
}

std::vector<std::string> foundIds(const Diagnosis& diagnosis) {
  std::vector<std::string> out;
  for (const doctor::Finding& finding : diagnosis.findings) out.push_back(finding.id);
  return out;
}

std::string spacedWords(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : " ") + word;
  return out;
}

} // namespace

std::string reportedName(const std::string& source) {
  return isBuiltinScene(source) ? source : capture::nameOf(source);
}

std::string doctorText(const Diagnosis& diagnosis, const std::string& source) {
  std::string text = reportedName(source) + ": " + diagnosis.lookedText() + "\n";
  if (diagnosis.isHealthy())
    text += diagnosis.healthySentence() + "\n";
  else if (!diagnosis.hasNews())
    text += say<"Nothing was found that is not known.">() + "\n";
  int number = 0;
  for (const doctor::Finding& finding : diagnosis.findings)
    text += "\n" + std::to_string(++number) + ". " + findingText(finding, diagnosis.frameNames);
  if (!diagnosis.parts.right().empty()) text += "\n" + say<"Right">() + "\n";
  for (const doctor::RightPart& right : diagnosis.parts.right()) text += "  " + right.sentence + "\n";
  if (!diagnosis.parts.undecided().empty()) text += "\n" + say<"Not decided by these frames">() + "\n";
  for (const Undecided& undecided : diagnosis.parts.undecided()) text += undecidedText(undecided);
  if (!diagnosis.notes.empty()) text += "\n" + say<"Notes">() + "\n";
  for (const std::string& note : diagnosis.notes) text += "  " + note + "\n";
  return text;
}

ordered_json doctorJson(const Diagnosis& diagnosis, const std::string& source) {
  return {{"source", reportedName(source)},
          {"frames", diagnosis.frames},
          {"pairs", diagnosis.pairs},
          {"healthy", diagnosis.isHealthy() && !diagnosis.isMisfit()},
          {"findings", listJson(diagnosis.findings,
                                [&](const doctor::Finding& finding) {
                                  return foundJson(finding, diagnosis.frameNames);
                                })},
          {"undecided", listJson(diagnosis.parts.undecided(), undecidedJson)},
          {"right", listJson(diagnosis.parts.right(), [](const auto& right) { return right.sentence; })},
          {"notes", diagnosis.notes}};
}

std::string correctedText(const doctor::CorrectedLook& look, const Diagnosis& diagnosis,
                          const Settings& given) {
  std::string text = "\n" + say<"Mended">() + "\n";
  if (look.corrected.findings.empty()) return text + "  " + say<"No setting makes this right.">() + "\n";
  for (const std::size_t finding : look.corrected.findings)
    text += "  " + diagnosis.findings[finding].name + "\n";
  const std::vector<std::string> names = foundIds(look.left);
  text += "  " + say<"By: %1">(spacedWords(differences(look.corrected.settings, given))) + "\n";
  text +=
      "  " +
      (names.empty() ? say<"Nothing wrong is found then.">() : say<"Found then: %1">(spacedWords(names))) +
      "\n";
  if (look.givenPsnr && look.correctedPsnr)
    text += "  " +
            say<"PSNR of frame %1: %2 dB as it is, %3 dB mended">(
                look.lastFrame, shortNumber(*look.givenPsnr), shortNumber(*look.correctedPsnr)) +
            "\n";
  return text;
}

ordered_json correctedJson(const doctor::CorrectedLook& look, const Diagnosis& diagnosis,
                           const Settings& given) {
  ordered_json out{
      {"findings", listJson(look.corrected.findings,
                            [&](std::size_t finding) { return diagnosis.findings[finding].id; })},
      {"settings", differences(look.corrected.settings, given)},
      {"left", foundIds(look.left)},
      {"frame", look.lastFrame}};
  if (look.givenPsnr && look.correctedPsnr)
    out["psnr"] = {{"given", *look.givenPsnr}, {"mended", *look.correctedPsnr}};
  return out;
}

} // namespace taa
