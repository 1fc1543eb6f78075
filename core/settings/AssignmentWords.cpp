#include "core/settings/AssignmentWords.h"

#include "core/base/Say.h"
#include "core/settings/Parameters.h"

#include <cstddef>

namespace taa {

std::string assignmentWords(std::string_view assignment) {
  const std::size_t split = assignment.find('=');
  const Parameter& row = parameter(assignment.substr(0, split));
  const std::string text(assignment.substr(split + 1));
  std::string value = text;
  if (row.kind == ParameterKind::Choice)
    value = sayLabel(row.choices[static_cast<std::size_t>(parseValue(row, text))].label);
  else if (row.kind == ParameterKind::Toggle)
    value = parseValue(row, text) != 0.0 ? say<"on">() : say<"off">();
  else if (text.starts_with('-'))
    value = "−" + text.substr(1);
  if (!row.unit.empty()) value += "\u2009" + sayLabel(row.unit);
  return say<"%1 ▸ %2: %3">(sayLabel(stageInfo(row.stage).label), sayLabel(row.label), value);
}

} // namespace taa
