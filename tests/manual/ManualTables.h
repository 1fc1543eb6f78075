// The pages of the manual that the program's tables know: written by `taa_manual pages`, held by a test.
#pragma once

#include "core/report/ManualPages.h"

#include <vector>

namespace taa {

/// coverage.md, settings.md, intermediates.md, presets.md, scenes.md, capturekeys.md, confusions.md and
/// faults.md, as they stand in the repository.
std::vector<ManualPage> manualTables();

} // namespace taa
