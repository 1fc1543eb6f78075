// The manual as the program carries it: resources/manual, in the order of its table of contents.
#pragma once

#include "core/report/ManualTables.h"

#include <string>
#include <vector>

namespace taa {

/// README.md, then the pages it links to, in the order of the links. Remarks for tools (<!-- … -->) are cut
/// out. Throws Error where a link leads nowhere.
std::vector<ManualPage> manualPages();

/// What a link to a heading calls it: "Threads and jobs" is "threads-and-jobs".
std::string headingAnchor(const std::string& heading);

} // namespace taa
