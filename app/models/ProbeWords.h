// What the core tells of a probe, as texts of the window.
#pragma once

#include "core/explanation/RowExplanation.h"
#include "core/taa/Intermediates.h"

#include <QString>
#include <glm/vec4.hpp>

namespace taa::app {

/// What happened at a row, its formula, and what the row is; the explanation may be empty.
QString explanationText(IntermediateId id, const RowExplanation& explanation);
QString explanationHtml(IntermediateId id, const RowExplanation& explanation);
/// The exact values of one row, separated by spaces.
QString rowText(const Intermediate& row, const glm::vec4& value);

} // namespace taa::app
