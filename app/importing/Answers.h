// What pixels answered about one convention, against what is stated now.
#pragma once

#include "core/capture/format/Conventions.h"
#include "core/capture/import/Guess.h"

#include <string_view>
#include <vector>

namespace taa::app {

/// Contradicted: the answer is sure, and another one of those that were compared is stated.
enum class Verdict { NotMeasured, NotSure, Sure, Contradicted };

/// The finding that says most about a convention: about itself, or one whose answers set it too; null: none.
const capture::Finding* findingOf(const std::vector<capture::Finding>& findings, std::string_view path);

/// Whether all that the hypothesis assigns is so already; what assigns nothing agrees with everything.
bool agrees(const capture::Hypothesis& hypothesis, const capture::Conventions& stated);

/// `finding` null: nothing was measured.
Verdict verdictOn(const capture::Finding* finding, const capture::Conventions& stated);

} // namespace taa::app
