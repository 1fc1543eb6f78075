// By what a search finds the rows of the tables.
#pragma once

#include "core/base/Search.h"
#include "core/settings/Parameters.h"
#include "core/taa/Intermediates.h"

namespace taa {

SearchedRow searchedRow(const Parameter& row);
/// One value of a choice or a switch alone: "Method: Clamp".
SearchedRow searchedValue(const Parameter& row, int value);
SearchedRow searchedRow(const Intermediate& row);

} // namespace taa
