#include "tests/manual/ManualTables.h"

#include "core/base/EmbeddedFiles.h"
#include "core/capture/format/Manifest.h"
#include "core/render/passes/SunView.h"
#include "core/report/Techniques.h"
#include "core/scene/builtin/SceneSource.h"
#include "core/settings/Faults.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"
#include "core/taa/ChannelNames.h"
#include "core/taa/Intermediates.h"
#include "tests/manual/ChoiceFunctions.h"
#include "tests/manual/Confusions.h"
#include "tests/manual/DoctorManual.h"
#include "tests/manual/ExamplePixel.h"
#include "tests/manual/VerdictLabels.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <initializer_list>
#include <sstream>
#include <string>
#include <string_view>

namespace taa {

namespace {

/// A text of a table as Markdown shows it letter by letter, in a cell of a table too.
std::string markdownText(std::string_view text) {
  std::string out;
  for (const char letter : text) {
    if (std::string_view("\\|*_<[]`~").find(letter) != std::string_view::npos) out += '\\';
    out += letter;
  }
  return out;
}

std::string code(std::string_view text) {
  return "`" + std::string(text) + "`";
}

/// A row of a table; what is in the cells is Markdown already.
std::string cells(std::initializer_list<std::string> texts) {
  std::string line = "|";
  for (const std::string& text : texts) line += " " + text + " |";
  return line + "\n";
}

std::string head(std::initializer_list<std::string> titles) {
  std::string line = "|";
  for (std::size_t column = 0; column < titles.size(); ++column) line += "---|";
  return cells(titles) + line + "\n";
}

/// The beginning of a page; `about` says what it holds.
std::string pageHead(const std::string& title, const std::string& about) {
  return "# " + title + "\n\n" + about +
         " `build/dev/bin/taa_manual pages resources/manual` writes this page from the program's tables; "
         "what is changed "
         "by hand here is lost.\n";
}

/// "`clampToBox` in taa/rectify_history.glsl".
std::string functionsText(const Technique& row) {
  std::string text;
  for (const ChoiceFunction& function : functionsOf(row))
    text += (text.empty() ? "" : ", ") + code(function.name) + " in " + function.file;
  return text;
}

ManualPage coveragePage() {
  ManualPage page{"coverage.md", "Techniques and the settings that choose them", ""};
  page.text =
      pageHead(page.title,
               "Each row of [the techniques](techniques.md), in its number: the setting that chooses it, as "
               "`--set` takes it, or why it is not there. Between backticks stand settings, intermediates "
               "and presets. Behind a choice of the resolve or the output stands the function that carries "
               "it out, and the kernel that it weighs samples by, with the file below `shaders`; the twin's "
               "have the same names in `core/taa/twin`.") +
      "\n" + head({"row", "technique", "here", "function"});
  for (const Technique& row : techniques())
    page.text +=
        cells({std::string(row.row), std::string(row.name), std::string(row.here), functionsText(row)});
  return page;
}

std::string rangeCell(const Parameter& row) {
  if (row.kind == ParameterKind::Choice) return "";
  if (row.kind == ParameterKind::Toggle) return "On or off";
  return valueText(row, row.minimum) + " to " + valueText(row, row.maximum) +
         (row.unit.empty() ? "" : " " + std::string(row.unit));
}

std::string parameterText(const Parameter& row) {
  std::string text =
      "\n### " + markdownText(row.label) + " " + code(row.path) + "\n\n" + markdownText(row.tooltip);
  if (!row.formula.empty()) text += " Formula: " + markdownText(row.formula) + ".";
  text += "\n\n";
  if (const std::string range = rangeCell(row); !range.empty())
    text += range + ", by";
  else
    text += "By";
  text += " default " + code(valueText(row, row.defaultValue())) + ".";
  if (const std::string when = relevantWhen(row); !when.empty())
    text += " Has an effect with " + code(when) + ".";
  text += " Source: " + markdownText(row.source) + ".\n";
  if (row.kind != ParameterKind::Choice) return text;
  text += "\n" + head({"choice", "shown as", "what it does"});
  for (const Choice& choice : row.choices)
    text += cells({code(choice.id), markdownText(choice.label), markdownText(choice.explanation)});
  return text;
}

/// The heading of a stage and its sentence; empty where nothing of the stage follows.
std::string stageText(const StageInfo& stage, const std::string& rows) {
  if (rows.empty()) return "";
  return "\n## " + markdownText(stage.label) + "\n\n" + markdownText(stage.description) + "\n" + rows;
}

ManualPage settingsPage() {
  ManualPage page{"settings.md", "Settings", ""};
  page.text =
      pageHead(page.title, "Every setting of the pipeline, by stage. `--set path=value` takes the code "
                           "beside each name; presets and sessions hold the same paths.");
  for (const StageInfo& stage : kStages) {
    std::string rows;
    for (const Parameter& row : parameters())
      if (row.stage == stage.stage) rows += parameterText(row);
    page.text += stageText(stage, rows);
  }
  return page;
}

/// Files below shaders/taa besides the one of a stage's id that are its.
struct FileOfStage {
  Stage stage;
  std::string_view id;
};
constexpr FileOfStage kFilesOfStages[] = {
    {Stage::FilterCurrent, "upsample"},
    {Stage::ValidateHistory, "compare_depth"},
    {Stage::ValidateHistory, "compare_geometry"},
    {Stage::RectifyHistory, "hold_history"},
    {Stage::Blend, "dither"},
    {Stage::Output, "sharpen"},
};

/// A texture's name as the flow has it: "u_historyColor" is "history.color".
std::string textureName(std::string_view name) {
  constexpr std::string_view kHistory = "history";
  if (!name.starts_with(kHistory)) return std::string(name);
  std::string layer(name.substr(kHistory.size()));
  layer.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(layer.front())));
  return "history." + layer;
}

/// The words behind `prefix` in a stage's shader, each once, in their order. Declarations, comments and what
/// is only exposed are no part of it.
std::vector<std::string> wordsOfStage(const StageInfo& stage, std::string_view prefix) {
  std::string text = embeddedText("shaders/taa/" + std::string(stage.id) + ".glsl");
  for (const FileOfStage& file : kFilesOfStages)
    if (file.stage == stage.stage) text += embeddedText("shaders/taa/" + std::string(file.id) + ".glsl");
  std::vector<std::string> words;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    line.resize(std::min(line.find("//"), line.size()));
    if (line.starts_with("layout(") || line.find("expose_") != line.npos) continue;
    for (std::size_t at = line.find(prefix); at != line.npos; at = line.find(prefix, at + 1)) {
      const std::size_t from = at + prefix.size();
      std::size_t end = from;
      while (end < line.size() && std::isalnum(static_cast<unsigned char>(line[end]))) ++end;
      const std::string word = line.substr(from, end - from);
      if (!word.empty() && std::ranges::find(words, word) == words.end()) words.push_back(word);
    }
  }
  return words;
}

/// Which textures each stage reads and which it writes, drawn from the shaders.
std::string flowText() {
  std::string rows;
  for (const StageInfo& stage : kStages) {
    if (stage.stage == Stage::Jitter || stage.stage > Stage::Output) continue;
    std::string reads, writes;
    for (const std::string& name : wordsOfStage(stage, "u_"))
      reads += (reads.empty() ? "" : ", ") + textureName(name);
    if (reads.empty()) reads = "no texture";
    if (stage.stage == Stage::Blend) writes = "resolved = history.color, history.surface";
    if (stage.stage == Stage::Output) writes = "output";
    for (const std::string& layer : wordsOfStage(stage, "keep_"))
      writes += (writes.empty() ? "" : ", ") + std::string("history.") + layer;
    const std::string label(stage.label);
    const std::size_t wide = 52;
    rows +=
        label + std::string(18 - std::min<std::size_t>(label.size(), 17), ' ') + "│ " + reads +
        (writes.empty() ? "" : std::string(wide - std::min(reads.size(), wide - 1), ' ') + "──► " + writes) +
        "\n" + (stage.stage == Stage::Output ? "" : "        ▼         │\n");
  }
  return "\n## The flow\n\nOne program runs all stages from Inputs to Blend for a pixel; what a stage hands "
         "to the next "
         "stays in registers. These are the textures that each reads and writes. A history that is read is "
         "the one that "
         "the frame before has written; history.surface holds N and depth, and the layers object, normal, "
         "motion, lock "
         "and lumas are kept where settings need them.\n\n```text\n" +
         rows + "```\n";
}

ManualPage intermediatesPage() {
  ManualPage page{"intermediates.md", "Intermediates", ""};
  page.text = pageHead(page.title, "Everything of a frame that can be looked at, probed and exported, by the "
                                   "stage that computes it. Colors are scene-linear, Rec. 709.");
  page.text += flowText();
  for (const StageInfo& stage : kStages) {
    std::string rows;
    for (const Intermediate& row : kIntermediates)
      if (row.stage == stage.stage)
        rows += cells({code(row.name), markdownText(row.label), markdownText(row.description),
                       markdownText(channelNamesText(row)), markdownText(row.unit)});
    if (!rows.empty()) rows = "\n" + head({"id", "shown as", "what it is", "channels", "unit"}) + rows;
    page.text += stageText(stage, rows);
  }
  page.text +=
      "\n## A pixel\n\nAs the probe writes it, from how each value was made, here by `balanced` at the "
      "rim of something bright that moves: what changes nothing is left out.\n\n" +
      head({"id", "what happened", "formula", "why"});
  for (const ExampleRow& row : exampleRows())
    page.text += cells({code(intermediate(row.id).name), markdownText(row.explanation.words),
                        markdownText((row.explanation.subject.empty() ? "" : row.explanation.subject + ": ") +
                                     row.explanation.formula),
                        markdownText(becauseText(row.explanation))});
  return page;
}

ManualPage presetsPage() {
  ManualPage page{"presets.md", "Presets", ""};
  page.text =
      pageHead(page.title, "The built-in settings, as the lists of the program group them. The sources "
                           "are named in [Sources](sources.md). A step adds one listing of its source "
                           "to those before it.");
  for (const PresetGroup& group : kPresetGroups) {
    page.text += "\n## " + markdownText(group.label) + "\n\n" + head({"id", "shown as", "what it is"});
    for (const Preset& preset : builtinPresets())
      if (preset.group == group.id)
        page.text += cells({code(preset.id), markdownText(preset.label), markdownText(preset.description)});
  }
  return page;
}

ManualPage scenesPage() {
  ManualPage page{"scenes.md", "Built-in scenes", ""};
  page.text =
      pageHead(
          page.title,
          "Scenes that each provoke something. They are opened by the code beside them. The window and "
          "lessons open one with the settings that show it, as far as these are at their defaults; "
          "`taa-batch` takes settings as they are given. Shadows are those of `inputs.shadows=asScene`.") +
      "\n" + head({"scene", "shown as", "what it shows", "shadows", "opened with"});
  const auto shadowsIn = [](const BuiltinScene& scene) {
    Settings settings;
    settings.inputs.shadows = shadowsOf(scene.shadows);
    const Parameter& row = parameter("inputs.shadows");
    return valueText(row, row.get(settings));
  };
  for (const BuiltinScene& scene : builtinScenes()) {
    std::string settings;
    for (const std::string& assignment : scene.settings)
      settings += (settings.empty() ? "" : ", ") + code(assignment);
    page.text += cells({code("builtin:" + scene.id), markdownText(scene.label),
                        markdownText(scene.description), shadowsIn(scene), settings});
  }
  return page;
}

std::string allowedText(const capture::Convention& row) {
  using Kind = capture::ConventionKind;
  if (row.kind == Kind::Choice || row.kind == Kind::OptionalChoice) return "";
  if (row.kind == Kind::Toggle) return "On or off";
  std::string text = row.kind == Kind::Integer ? "A whole number" : "A number";
  if (row.kind == Kind::OptionalNumber) return text + " or `none`";
  return row.unit.empty() ? text : text + ", " + std::string(row.unit);
}

std::string conventionText(const capture::Convention& row) {
  std::string text =
      "\n### " + markdownText(row.label) + " " + code(row.path) + "\n\n" + markdownText(row.tooltip) + "\n\n";
  if (const std::string allowed = allowedText(row); !allowed.empty())
    text += allowed + ", by";
  else
    text += "By";
  text += " default " + code(row.text({})) + ".";
  if (!row.when.empty()) text += " Has a meaning with " + code(row.when) + ".";
  text += "\n";
  if (row.choices.empty()) return text;
  text += "\n" + head({"choice", "shown as", "what it says"});
  for (const capture::ConventionChoice& choice : row.choices)
    text += cells({code(choice.id), markdownText(choice.label), markdownText(choice.explanation)});
  if (row.kind == capture::ConventionKind::OptionalChoice)
    text += cells({code("none"), "None of these", "What is stored is right."});
  return text;
}

/// A heading before the first row of a group: "motion" of "motion.unit".
std::string groupText(std::string_view path, std::string_view before) {
  const std::string_view group = path.substr(0, path.find('.'));
  if (group == before.substr(0, before.find('.'))) return "";
  const bool isAlone = path.find('.') == std::string_view::npos;
  return "\n## " + (isAlone ? "Conventions of files" : "Conventions of " + std::string(group)) + "\n";
}

std::string startingPointsText() {
  std::string text = "\n## Starting points\n\nWhat `like` names; conventions that are not listed are as by "
                     "default.\n\n" +
                     head({"id", "shown as", "conventions", "what to look at", "known from"});
  for (const capture::StartingPoint& point : capture::startingPoints()) {
    std::string said;
    for (const std::string& assignment : capture::differences(point.conventions, {}))
      said += (said.empty() ? "" : ", ") + code(assignment);
    text += cells({code(point.id), markdownText(point.label), said, markdownText(point.notes),
                   markdownText(point.source)});
  }
  return text;
}

std::string planesText() {
  std::string text = "\n## Planes\n\nValues are in the capture's conventions.\n\n" +
                     head({"plane", "channels", "what it holds"});
  for (std::size_t kind = 0; kind < capture::kPlaneKinds; ++kind) {
    const auto plane = static_cast<capture::PlaneKind>(kind);
    const int least = capture::minChannelsOf(plane), most = capture::channelsOf(plane);
    text += cells({code(capture::planeName(plane)),
                   std::to_string(least) + (most > least ? " or " + std::to_string(most) : ""),
                   markdownText(capture::planeDescription(plane))});
  }
  text += "\n## Raw formats\n\nWhat `raw` names, channels from the lowest address on:";
  for (std::size_t format = 0; format < capture::kRawFormats; ++format)
    text += (format > 0 ? ", " : " ") + code(capture::rawFormatName(static_cast<capture::RawFormat>(format)));
  return text + ".\n";
}

ManualPage captureKeysPage() {
  ManualPage page{"capturekeys.md", "Keys of captures", ""};
  page.text = pageHead(
      page.title, "Everything that a [capture](captures.md) can state of the frames of an engine. "
                  "`motion.unit` stands as `{\"motion\": {\"unit\": …}}` in `conventions` of capture.json, "
                  "and as `--set motion.unit=…` where a capture is imported.");
  std::string_view before;
  for (const capture::Convention& row : capture::conventions()) {
    page.text += groupText(row.path, before) + conventionText(row);
    before = row.path;
  }
  page.text += startingPointsText() + planesText();
  return page;
}

ManualPage confusionsPage() {
  ManualPage page{"confusions.md", "Verdicts against what people see", ""};
  page.text =
      pageHead(page.title,
               "Pixels of the built-in scenes at " + std::to_string(kLabelledSize.x) + " × " +
                   std::to_string(kLabelledSize.y) +
                   ", each with what is wrong there and which stage let it happen, said by looking at the "
                   "frames beside the reference (`tests/support/verdicts/labels.csv`), against the "
                   "[verdict](verdicts.md) on the same pixel (`tests/manual/verdicts.csv`, which "
                   "`TAA_VERDICTS=write build/dev/bin/taa_gl_tests --gtest_filter='VerdictLabels.*'` writes "
                   "and `ctest -C verdicts -L taa_verdicts` checks).") +
      confusionsText(judgedLabels());
  return page;
}

std::string codes(std::string_view words) {
  std::string text = "`";
  for (const char letter : words) text += letter == ' ' ? std::string("` `") : std::string(1, letter);
  return text + "`";
}

ManualPage faultsPage() {
  ManualPage page{"faults.md", "Faults", ""};
  page.text = pageHead(
      page.title,
      "Mistakes that integrations of TAA make, to be injected on purpose: into the frames of the built-in "
      "renderer and into those of a capture on their way in, one or several, to learn what they look like. "
      "Each is made by settings, as `--set` takes them; those of the group `fault` are "
      "[in the list of all](settings.md#faults), with what else there is of each: strength, region, frames. "
      "Input faults are applied between the source of frames and all that uses them, so that frame n stays a "
      "function; the [reference](metrics.md) has none. Where and when inputs are faulty is said once for "
      "all of them: motion, depth and exposure in `fault.region`, everything from `fault.firstFrame` to "
      "`fault.lastFrame`. Where it says so, a fault needs frames that are drawn: a capture's jitter, "
      "textures and transparent surfaces are in its pictures already.");
  constexpr std::array kParts{FaultPart::Jitter, FaultPart::Motion, FaultPart::Depth, FaultPart::Color,
                              FaultPart::Resolve};
  for (const FaultPart part : kParts) {
    page.text += "\n## " + markdownText(faultPartLabel(part)) + "\n\n" +
                 head({"id", "fault", "what one sees", "injected by", "into"});
    for (const FaultInfo& info : faultTable())
      if (info.part == part)
        page.text +=
            cells({code(info.id), markdownText(info.label), markdownText(info.symptom),
                   codes(info.assignments), info.reach == FaultReach::Any ? "any frames" : "drawn frames"});
  }
  page.text += doctorManual();
  return page;
}

} // namespace

std::vector<ManualPage> manualTables() {
  return {coveragePage(), settingsPage(),    intermediatesPage(), presetsPage(),
          scenesPage(),   captureKeysPage(), confusionsPage(),    faultsPage()};
}

} // namespace taa
