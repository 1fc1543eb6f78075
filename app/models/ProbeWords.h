// What the values of a probe mean, in words.
#pragma once

#include "core/inspect/ProbeStory.h"
#include "core/settings/Settings.h"
#include "core/taa/Intermediates.h"
#include "core/taa/reference/Reference.h"

#include <QStringList>

namespace taa::app {

/// A few words for a value that has some ("kept", "sky", "31 % current"); else empty.
QString valueWords(const Intermediate& row, const glm::vec4& value);

/// The pixel's story in lines: what moved, what was clipped, how α came about, and what is shown instead.
QStringList probeSummary(const reference::PixelRecord& record, const Settings& settings);

/// What happened at a row, its formula, and what the row is; the story may be empty.
QString storyText(IntermediateId id, const RowStory& story);
QString storyHtml(IntermediateId id, const RowStory& story);
/// The exact values of one row, separated by spaces.
QString rowText(const Intermediate& row, const glm::vec4& value);

} // namespace taa::app
