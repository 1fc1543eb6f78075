#include "tests/manual/VerdictLabels.h"

#include "core/base/Error.h"
#include "core/base/Files.h"
#include "tests/support/Paths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string_view>
#include <utility>

namespace taa {

namespace {

constexpr std::string_view kLabelHeading = "scene,preset,frame,x,y,kind,stages,why";
constexpr std::string_view kJudgedHeading = "scene,preset,frame,x,y,kind,stages,named,stage,remedy,"
                                            "pixelBefore,pixelAfter,pictureBefore,pictureAfter,why";

std::vector<std::string> partsOfLine(const std::string& text, char separator, std::size_t most) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t at = text.find(separator); at != std::string::npos && parts.size() + 1 < most;
       at = text.find(separator, begin)) {
    parts.push_back(text.substr(begin, at - begin));
    begin = at + 1;
  }
  parts.push_back(text.substr(begin));
  return parts;
}

VerdictKind verdictKindOf(const std::string& id, const std::string& place) {
  for (const VerdictKindInfo& info : kVerdictKinds)
    if (info.id == id) return info.kind;
  throw Error(place + ": there is no kind of verdict \"" + id + "\"");
}

Stage labelStageOf(const std::string& id, const std::string& place) {
  for (const StageInfo& info : kStages)
    if (info.id == id) return info.stage;
  throw Error(place + ": there is no stage \"" + id + "\"");
}

int labelNumberIn(const std::string& text, const std::string& place) {
  if (text.empty() || !std::ranges::all_of(text, [](char digit) { return digit >= '0' && digit <= '9'; }))
    throw Error(place + ": \"" + text + "\" is no number");
  return std::stoi(text);
}

double labelErrorIn(const std::string& text, const std::string& place) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0') throw Error(place + ": \"" + text + "\" is no number");
  return value;
}

/// Of the columns that both tables begin with; the last is `why` in both.
VerdictLabel labelOf(const std::vector<std::string>& parts, const std::string& place) {
  VerdictLabel label;
  label.scene = parts[0];
  label.preset = parts[1];
  label.frame = labelNumberIn(parts[2], place);
  label.pixel = {labelNumberIn(parts[3], place), labelNumberIn(parts[4], place)};
  label.kind = verdictKindOf(parts[5], place);
  for (const std::string& id : partsOfLine(parts[6], '|', parts[6].size()))
    label.stages.push_back(labelStageOf(id, place));
  label.why = parts.back();
  return label;
}

JudgedLabel judgedLabelOf(const std::vector<std::string>& parts, const std::string& place) {
  JudgedLabel judged{
      labelOf(parts, place), verdictKindOf(parts[7], place), labelStageOf(parts[8], place), {}};
  judged.remedy = {parts[9], labelErrorIn(parts[10], place), labelErrorIn(parts[11], place),
                   labelErrorIn(parts[12], place), labelErrorIn(parts[13], place)};
  return judged;
}

/// Calls `read(parts, place)` for each line below the heading.
template <typename Read>
void readLabelLines(const std::string& text, const std::string& place, std::string_view heading, Read read) {
  const auto columns = static_cast<std::size_t>(std::ranges::count(heading, ',')) + 1;
  std::istringstream lines(text);
  std::string line;
  if (!std::getline(lines, line) || line != heading)
    throw Error(place + ": the first line must be \"" + std::string(heading) + "\"");
  for (int number = 2; std::getline(lines, line); ++number) {
    const std::string where = place + ":" + std::to_string(number);
    const std::vector<std::string> parts = partsOfLine(line, ',', columns);
    if (parts.size() != columns) throw Error(where + ": " + std::string(heading) + " is expected");
    read(parts, where);
  }
}

std::string errorStepsText(double steps) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f", steps);
  return text.data();
}

} // namespace

bool JudgedLabel::isStageRight() const {
  return std::ranges::find(label.stages, stage) != label.stages.end();
}

std::vector<VerdictLabel> verdictLabelsFrom(const std::string& text, const std::string& place) {
  std::vector<VerdictLabel> labels;
  readLabelLines(text, place, kLabelHeading, [&](const auto& parts, const std::string& where) {
    labels.push_back(labelOf(parts, where));
  });
  return labels;
}

std::vector<JudgedLabel> judgedLabelsFrom(const std::string& text, const std::string& place) {
  std::vector<JudgedLabel> judged;
  readLabelLines(text, place, kJudgedHeading, [&](const auto& parts, const std::string& where) {
    judged.push_back(judgedLabelOf(parts, where));
  });
  return judged;
}

std::string judgedLabelsText(const std::vector<JudgedLabel>& judged) {
  std::string text(kJudgedHeading);
  text += '\n';
  for (const JudgedLabel& entry : judged) {
    const VerdictLabel& label = entry.label;
    std::string stages;
    for (const Stage stage : label.stages)
      stages.append(stages.empty() ? "" : "|").append(stageInfo(stage).id);
    const LabelRemedy& remedy = entry.remedy;
    for (const std::string& cell :
         {label.scene, label.preset, std::to_string(label.frame), std::to_string(label.pixel.x),
          std::to_string(label.pixel.y), std::string(kVerdictKinds[static_cast<std::size_t>(label.kind)].id),
          stages, std::string(kVerdictKinds[static_cast<std::size_t>(entry.kind)].id),
          std::string(stageInfo(entry.stage).id), remedy.changes, errorStepsText(remedy.pixelBefore),
          errorStepsText(remedy.pixelAfter), errorStepsText(remedy.pictureBefore),
          errorStepsText(remedy.pictureAfter)})
      text += cell + ",";
    text += label.why + "\n";
  }
  return text;
}

std::vector<JudgedLabel> judgedLabels() {
  const std::filesystem::path file = test::rootFolder() / kJudgedLabelsFile;
  return judgedLabelsFrom(readFile(file), file.string());
}

} // namespace taa
