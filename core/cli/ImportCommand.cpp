// taa-batch import: what a folder of somebody's frames is, and how sure that is, as a capture.
#include "core/base/NumberText.h"
#include "core/base/ShownText.h"
#include "core/capture/import/Guess.h"
#include "core/capture/import/SavedImport.h"
#include "core/capture/import/StatedPlanes.h"
#include "core/cli/Command.h"
#include "core/cli/Options.h"
#include "core/cli/Table.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

namespace taa::cli {

using nlohmann::ordered_json;

namespace {

struct ImportCommand final : Command {
  std::string folder, out; ///< out empty: it is only measured
  std::string like;        ///< id of a starting point; empty: none
  std::vector<std::string> assignments, planes;
  bool checks = false; ///< what contradicts what is stated makes the exit code
  bool force = false, json = false;

  ImportCommand() : Command("import") {
    description("Say what a folder of an engine's frames is, by names, side files and pixels, and write it "
                "as a capture");
    add_option("FOLDER", folder, "Holds pictures (EXR, PNG, HDR, TIFF, DDS), or capture.json")->required();
    add_option("--like", like,
               "Whose conventions are taken where pixels decide nothing else: " + startingPointIds());
    add_option("--set", assignments,
               "key=value of a convention, which is then not questioned; repeat it for more")
        ->allow_extra_args(false);
    add_option(
        "--plane", planes,
        "KIND=FILES:CHANNELS, as motion=dmv_{frame:4}.exr:G,B: what these files hold, whatever they are "
        "called; repeat it for more")
        ->allow_extra_args(false);
    CLI::Option* written =
        add_option("--out", out,
                   "Folder of capture.json. Planes stay where they are when that is below "
                   "it, and are linked or copied into it otherwise; without it nothing is written");
    add_flag("--check", checks,
             "Write nothing, and end with 3 where pixels contradict a convention that is stated")
        ->excludes(written);
    addForce(*this, force);
    addJson(*this, json);
  }

  int run(std::ostream& output, const Progress& progress) const override;
};

std::string spaced(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : " ") + part;
  return text;
}

void printFinding(std::ostream& out, const capture::Finding& finding) {
  out << finding.question << ": " << (finding.isSure ? "sure" : "not sure") << ", " << finding.reason << '\n';
  std::vector<std::vector<std::string>> rows = {{finding.measure + ":"}};
  for (const capture::Hypothesis& hypothesis : finding.hypotheses)
    rows.push_back({hypothesis.isChosen ? "*" : " ", hypothesis.text, significantText(hypothesis.residual, 4),
                    finding.path == "like" ? "" : spaced(hypothesis.assignments)});
  printTable(out, rows, "  ");
}

void printSentences(std::ostream& out, const std::string& title, const std::vector<std::string>& sentences) {
  if (sentences.empty()) return;
  out << '\n' << title << '\n';
  for (const std::string& sentence : sentences) out << "  " << shownLine(sentence) << '\n';
}

void printGuess(std::ostream& out, const capture::Guess& guess) {
  const capture::Manifest& manifest = guess.manifest;
  out << manifest.name << ": " << manifest.frames.size() << " frames, " << manifest.sizePx.x << "x"
      << manifest.sizePx.y << (manifest.like.empty() ? "" : ", like " + manifest.like) << "\n\n";
  for (const capture::Finding& finding : guess.findings) printFinding(out, finding);
  printSentences(out, "Sure", guess.sure);
  printSentences(out, "Not sure", guess.unsure);
  printSentences(out, "Missing", guess.missing);
}

ordered_json findingJson(const capture::Finding& finding) {
  ordered_json hypotheses = ordered_json::array();
  for (const capture::Hypothesis& hypothesis : finding.hypotheses)
    hypotheses.push_back({{"text", hypothesis.text},
                          {"assignments", hypothesis.assignments},
                          {"residual", hypothesis.residual},
                          {"chosen", hypothesis.isChosen}});
  return {{"question", finding.question}, {"path", finding.path},
          {"sure", finding.isSure},       {"reason", finding.reason},
          {"measure", finding.measure},   {"contradicts", finding.contradicts()},
          {"hypotheses", hypotheses}};
}

ordered_json guessJson(const capture::Guess& guess) {
  ordered_json findings = ordered_json::array();
  for (const capture::Finding& finding : guess.findings) findings.push_back(findingJson(finding));
  return {{"capture", ordered_json::parse(capture::manifestText(guess.manifest))},
          {"findings", findings},
          {"sure", guess.sure},
          {"unsure", guess.unsure},
          {"missing", guess.missing}};
}

int ImportCommand::run(std::ostream& output, const Progress& progress) const {
  std::vector<std::string> stated = assignments;
  for (const std::string& plane : planes) stated.push_back(std::string(capture::kPlanePrefix) + plane);
  const capture::Guess guess = capture::guessCapture(folder, like, stated, progress);
  ordered_json result;
  if (json)
    result = guessJson(guess);
  else
    printGuess(output, guess);
  if (out.empty() && !checks && !json)
    output
        << "\nNothing is written: give --out FOLDER, or --check to end with 3 where pixels contradict what is "
           "stated\n";
  if (!out.empty()) {
    const capture::SavedImport saved = capture::saveImport(folder, guess.manifest, out, force, progress);
    result["written"] = saved.manifest.string();
    if (!json) output << '\n' << saved.manifest.string() << '\n';
  }
  if (json) print(output, result);
  const bool isContradicted = std::ranges::any_of(guess.findings, &capture::Finding::contradicts);
  return checks && isContradicted ? kFindings : kDone;
}

} // namespace

std::shared_ptr<Command> importCommand() {
  return std::make_shared<ImportCommand>();
}

} // namespace taa::cli
