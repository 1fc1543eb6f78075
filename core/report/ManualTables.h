// The pages of the manual that the program's tables know: written by `taa-batch manual`, held by a test.
#pragma once

#include <string>
#include <vector>

namespace taa {

/// A page of resources/manual.
struct ManualPage {
  std::string file; ///< "settings.md"
  std::string title;
  std::string text; ///< Markdown, English whatever the language of the program
};

/// coverage.md, settings.md, intermediates.md, presets.md, scenes.md, capturekeys.md, confusions.md and
/// faults.md, as they stand in the repository.
std::vector<ManualPage> manualTables();

} // namespace taa
