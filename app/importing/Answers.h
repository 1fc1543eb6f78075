// What pixels answered about one convention, against what is stated now.
#pragma once

#include "core/capture/format/Conventions.h"
#include "core/capture/import/Guess.h"

#include <string_view>
#include <vector>

namespace taa::app {

/// Contradicted: the answer is sure, and another one of those that were compared is stated.
enum class Verdict { NotMeasured, NotSure, Sure, Contradicted };

/// Of the findings about a convention, else of those whose answers set it too, the one that leaves most doubt
/// of what is stated: it is contradicted before it is not sure; null: none.
const capture::Finding* findingOf(const std::vector<capture::Finding>& findings, std::string_view path,
                                  const capture::Conventions& stated);

/// Whether all that the hypothesis assigns is so already; never of one that no convention says.
bool agrees(const capture::Hypothesis& hypothesis, const capture::Conventions& stated);

/// `finding` null: nothing was measured.
Verdict verdictOn(const capture::Finding* finding, const capture::Conventions& stated);

} // namespace taa::app
