// What the core tells of a probe, as texts of the window.
#pragma once

#include "core/story/ProbeStory.h"
#include "core/taa/Intermediates.h"

#include <QString>
#include <glm/vec4.hpp>

namespace taa::app {

/// What happened at a row, its formula, and what the row is; the story may be empty.
QString storyText(IntermediateId id, const RowStory& story);
QString storyHtml(IntermediateId id, const RowStory& story);
/// The exact values of one row, separated by spaces.
QString rowText(const Intermediate& row, const glm::vec4& value);

} // namespace taa::app
