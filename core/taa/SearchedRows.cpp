#include "core/taa/SearchedRows.h"

#include "core/base/Say.h"

#include <cstddef>
#include <string>

namespace taa {

namespace {

SearchedChoice searchedChoice(const Choice& choice) {
  return {std::string(choice.id), std::string(choice.label), std::string(choice.explanation)};
}

SearchedRow withoutChoices(const Parameter& row) {
  return {.label = std::string(row.label),
          .id = std::string(row.path),
          .group = std::string(stageInfo(row.stage).label),
          .choices = {},
          .text =
              std::string(row.tooltip) + '\n' + std::string(row.formula) + '\n' + std::string(row.source)};
}

} // namespace

SearchedRow searchedRow(const Parameter& row) {
  SearchedRow searched = withoutChoices(row);
  for (const Choice& choice : row.choices) searched.choices.push_back(searchedChoice(choice));
  return searched;
}

SearchedRow searchedValue(const Parameter& row, int value) {
  SearchedRow searched = withoutChoices(row);
  if (row.kind == ParameterKind::Choice)
    searched.choices.push_back(searchedChoice(row.choices[static_cast<std::size_t>(value)]));
  else
    searched.choices.push_back(
        {valueText(row, value), value != 0 ? say<"on">() : say<"off">(), std::string()});
  searched.label = say<"%1: %2">(searched.label, searched.choices[0].label);
  return searched;
}

SearchedRow searchedRow(const Intermediate& row) {
  return {.label = std::string(row.label),
          .id = std::string(row.name),
          .group = std::string(stageInfo(row.stage).label),
          .choices = {},
          .text = std::string(row.description)};
}

} // namespace taa
