// The manual as the program carries it: resources/manual, in the order of its table of contents.
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

/// README.md, then the pages it links to, in the order of the links. Remarks for tools (<!-- … -->) are cut
/// out. Throws Error where a link leads nowhere.
std::vector<ManualPage> manualPages();

/// What a link to a heading calls it: "Threads and jobs" is "threads-and-jobs".
std::string headingAnchor(const std::string& heading);

} // namespace taa
