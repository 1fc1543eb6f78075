#include "core/inspect/ReferencePage.h"

#include "core/settings/Parameters.h"
#include "core/taa/Intermediates.h"

namespace taa {

namespace {

std::string escaped(std::string_view text) {
  std::string out;
  for (char letter : text) {
    switch (letter) {
    case '&':
      out += "&amp;";
      break;
    case '<':
      out += "&lt;";
      break;
    case '>':
      out += "&gt;";
      break;
    default:
      out += letter;
    }
  }
  return out;
}

std::string rangeText(const Parameter& row) {
  if (row.kind == ParameterKind::Toggle) return "on, off";
  if (row.kind != ParameterKind::Choice)
    return valueText(row, row.minimum) + " … " + valueText(row, row.maximum) +
           (row.unit.empty() ? "" : " " + std::string(row.unit));
  std::string text;
  for (const Choice& choice : row.choices)
    text += (text.empty() ? "" : "<br>") + escaped(choice.id) + ": " + escaped(choice.explanation);
  return text;
}

std::string parameterHtml(const Parameter& row) {
  std::string text = "<tr><td><b>" + escaped(row.label) + "</b><br><code>" + escaped(row.path) +
                     "</code></td><td>" + escaped(row.tooltip);
  if (!row.formula.empty()) text += "<br><i>" + escaped(row.formula) + "</i>";
  return text + "<br>" + escaped(row.source) + "</td><td>" + rangeText(row) + "</td><td>" +
         escaped(valueText(row, row.defaultValue())) + "</td></tr>\n";
}

std::string intermediateHtml(const Intermediate& row) {
  std::string channels;
  for (const std::string& name : channelNames(row)) channels += (channels.empty() ? "" : ", ") + name;
  return "<tr><td><b>" + escaped(row.label) + "</b><br><code>" + std::string(row.name) + "</code></td><td>" +
         escaped(row.description) + "</td><td>" + escaped(channels) + "</td><td>" + escaped(row.unit) +
         "</td></tr>\n";
}

constexpr std::string_view kTable = "<table cellpadding=\"4\" cellspacing=\"0\" width=\"100%\">\n";

std::string stageHtml(const StageInfo& stage) {
  std::string parametersText, intermediatesText;
  for (const Parameter& row : parameters())
    if (row.stage == stage.stage) parametersText += parameterHtml(row);
  for (const Intermediate& row : kIntermediates)
    if (row.stage == stage.stage) intermediatesText += intermediateHtml(row);
  std::string text = "<h2>" + escaped(stage.label) + "</h2>\n<p>" + escaped(stage.description) + "</p>\n";
  if (!parametersText.empty())
    text += std::string(kTable) +
            "<tr><th align=\"left\">Parameter</th><th align=\"left\">What it does</th><th "
            "align=\"left\">Range</th>"
            "<th align=\"left\">Default</th></tr>\n" +
            parametersText + "</table>\n";
  if (!intermediatesText.empty())
    text += std::string(kTable) +
            "<tr><th align=\"left\">Intermediate</th><th align=\"left\">What it is</th><th "
            "align=\"left\">Channels</th>"
            "<th align=\"left\">Unit</th></tr>\n" +
            intermediatesText + "</table>\n";
  return text;
}

} // namespace

std::string referencePageHtml() {
  std::string text =
      "<h1>Reference</h1>\n<p>Each frame goes through these stages from top to bottom. Parameters can be "
      "set in the pipeline panel, in presets, and by <code>--set path=value</code>; intermediates can be "
      "viewed, probed and exported.</p>\n";
  for (const StageInfo& stage : kStages) text += stageHtml(stage);
  return text;
}

} // namespace taa
