// taa-batch import: what a folder of somebody's frames is, and how sure that is, as a capture.
#include "core/cli/Commands.h"

#include "core/base/NumberText.h"
#include "core/base/ShownText.h"
#include "core/capture/import/Guess.h"
#include "core/capture/import/SavedImport.h"
#include "core/cli/Table.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

namespace taa::cli {

using nlohmann::ordered_json;

namespace {

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

} // namespace

bool runImport(const ImportArguments& arguments, std::ostream& out, const Progress& progress) {
  if (arguments.out.empty() && !arguments.check)
    throw UsageError("--out FOLDER is required, or --check to measure without writing");
  const capture::Guess guess =
      capture::guessCapture(arguments.folder, arguments.like, arguments.assignments, progress);
  ordered_json json;
  if (arguments.json)
    json = guessJson(guess);
  else
    printGuess(out, guess);
  if (!arguments.check) {
    const capture::SavedImport saved =
        capture::saveImport(arguments.folder, guess.manifest, arguments.out, arguments.force, progress);
    json["written"] = saved.manifest.string();
    if (!arguments.json) out << '\n' << saved.manifest.string() << '\n';
  }
  if (arguments.json) out << json.dump(2) << '\n';
  return std::ranges::any_of(guess.findings, &capture::Finding::contradicts);
}

} // namespace taa::cli
