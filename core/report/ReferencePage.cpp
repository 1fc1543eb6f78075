#include "core/report/ReferencePage.h"

#include "core/base/HtmlText.h"
#include "core/base/Say.h"
#include "core/settings/Parameters.h"
#include "core/taa/ChannelNames.h"
#include "core/taa/Intermediates.h"

#include <string>
#include <string_view>
#include <vector>

namespace taa {

namespace {

/// A text of the tables, in the user's language.
std::string htmlLabel(std::string_view text) {
  return htmlText(sayLabel(text));
}

std::string htmlRange(const Parameter& row) {
  if (row.kind == ParameterKind::Toggle) return say<"on, off">();
  if (row.kind != ParameterKind::Choice)
    return valueText(row, row.minimum) + " … " + valueText(row, row.maximum) +
           (row.unit.empty() ? "" : " " + sayLabel(row.unit));
  std::string text;
  for (const Choice& choice : row.choices)
    text += (text.empty() ? "" : "<br>") + htmlText(choice.id) + ": " + htmlLabel(choice.explanation);
  return text;
}

/// Above what is said of it: names have the whole width, however large the letters are.
std::string nameHtml(std::string_view label, std::string_view name) {
  return "<tr><td colspan=\"3\"><b>" + htmlLabel(label) + "</b> <code>" + htmlText(name) +
         "</code></td></tr>\n";
}

std::string parameterHtml(const Parameter& row) {
  std::string text = nameHtml(row.label, row.path) + "<tr><td>" + htmlLabel(row.tooltip);
  if (!row.formula.empty()) text += "<br><i>" + htmlLabel(row.formula) + "</i>";
  return text + "<br>" + htmlLabel(row.source) + "</td><td>" + htmlRange(row) + "</td><td>" +
         htmlText(valueText(row, row.defaultValue())) + "</td></tr>\n";
}

std::string intermediateHtml(const Intermediate& row) {
  return nameHtml(row.label, row.name) + "<tr><td>" + htmlLabel(row.description) + "</td><td>" +
         htmlText(channelNamesText(row)) + "</td><td>" + htmlLabel(row.unit) + "</td></tr>\n";
}

constexpr std::string_view kTableTag = "<table cellpadding=\"4\" cellspacing=\"0\" width=\"100%\">\n";

struct Column {
  std::string title;
  int percent; ///< of the width: sentences have more than names, which are as wide where nothing is said
};

std::string headHtml(const std::vector<Column>& columns) {
  std::string text = "<tr>";
  for (const Column& column : columns)
    text += "<th align=\"left\" width=\"" + std::to_string(column.percent) + "%\">" + htmlText(column.title) +
            "</th>";
  return text + "</tr>\n";
}

std::string stageHtml(const StageInfo& stage) {
  std::string parametersText, intermediatesText;
  for (const Parameter& row : parameters())
    if (row.stage == stage.stage) parametersText += parameterHtml(row);
  for (const Intermediate& row : kIntermediates)
    if (row.stage == stage.stage) intermediatesText += intermediateHtml(row);
  std::string text = "<h2>" + htmlLabel(stage.label) + "</h2>\n<p>" + htmlLabel(stage.description) + "</p>\n";
  if (!parametersText.empty())
    text += std::string(kTableTag) +
            headHtml(
                {{say<"Parameters, and what they do">(), 48}, {say<"Range">(), 36}, {say<"Default">(), 16}}) +
            parametersText + "</table>\n";
  if (!intermediatesText.empty())
    text +=
        std::string(kTableTag) +
        headHtml(
            {{say<"Intermediates, and what they are">(), 68}, {say<"Channels">(), 16}, {say<"Unit">(), 16}}) +
        intermediatesText + "</table>\n";
  return text;
}

} // namespace

std::string referencePageHtml() {
  std::string text =
      "<h1>" + htmlText(say<"Settings and intermediates">()) + "</h1>\n<p>" +
      say<"Each frame goes through these stages from top to bottom. Parameters can be set in the pipeline "
          "panel, in presets, and by %1; intermediates can be viewed, probed and exported.">(
          "<code>--set path=value</code>") +
      "</p>\n";
  for (const StageInfo& stage : kStages) text += stageHtml(stage);
  return text;
}

} // namespace taa
