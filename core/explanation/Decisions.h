// Why a row has its value: the comparisons that decided which way the twin went.
#pragma once

#include "core/settings/Settings.h"
#include "core/taa/twin/Traced.h"

#include <string>
#include <vector>

namespace taa::explanation {

/// "depth mismatch 0.31 > depth allowed 0.02", in the order they were made: those with a row or a number of
/// the settings on one side at least. `settings`: that made the trace.
std::vector<std::string> decisionTexts(const twin::Trace& trace, IntermediateId id, const Settings& settings,
                                       int digits);

} // namespace taa::explanation
