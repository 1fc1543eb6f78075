#include "core/settings/AssignmentWords.h"

#include "core/base/Say.h"
#include "core/settings/Parameters.h"

#include <cmath>
#include <cstddef>
#include <cstdio>

namespace taa {

namespace {

/// Four significant digits, with a typographic minus.
std::string roundedText(double number) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.4g", std::fabs(number));
  return (number < 0.0 ? "−" : "") + std::string(text);
}

} // namespace

std::string assignmentWords(std::string_view assignment) {
  const std::size_t split = assignment.find('=');
  const Parameter& row = parameter(assignment.substr(0, split));
  const double number = parseValue(row, assignment.substr(split + 1));
  std::string value;
  if (row.kind == ParameterKind::Choice)
    value = std::string(row.choices[static_cast<std::size_t>(number)].label);
  else if (row.kind == ParameterKind::Toggle)
    value = number != 0.0 ? say<"on">() : say<"off">();
  else
    value = roundedText(number);
  if (!row.unit.empty()) value += "\u2009" + std::string(row.unit);
  return say<"%1 ▸ %2: %3">(std::string(stageInfo(row.stage).label), std::string(row.label), value);
}

} // namespace taa
