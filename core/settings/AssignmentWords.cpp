#include "core/settings/AssignmentWords.h"

#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/settings/Parameters.h"

#include <cstddef>

namespace taa {

std::string assignmentWords(std::string_view assignment) {
  const std::size_t split = assignment.find('=');
  const Parameter& row = parameter(assignment.substr(0, split));
  const double number = parseValue(row, assignment.substr(split + 1));
  std::string value;
  if (row.kind == ParameterKind::Choice)
    value = row.choices[static_cast<std::size_t>(number)].label;
  else if (row.kind == ParameterKind::Toggle)
    value = number != 0.0 ? say<"on">() : say<"off">();
  else
    value = numberText(number);
  if (!row.unit.empty()) value += "\u2009" + std::string(row.unit);
  return say<"%1 ▸ %2: %3">(stageInfo(row.stage).label, row.label, value);
}

} // namespace taa
