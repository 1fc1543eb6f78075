// Rows that a history holds just as the resolve gave them: looking at them needs no inputs and no resolve.
#pragma once

#include "core/taa/TaaPass.h"

#include <vector>

namespace taa {

/// Whether the history that a frame left holds `id` bit for bit.
bool isStored(IntermediateId id, const Settings& settings);

/// The whole picture of rows that are stored.
Exposure storedRows(const History& history, const std::vector<IntermediateId>& ids);

} // namespace taa
