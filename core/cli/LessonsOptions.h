// The command about lessons, and its options.
#pragma once

#include "core/base/Progress.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace taa::cli {

struct LessonsArguments {
  std::vector<std::string> files; ///< Markdown; empty: the built-in ones
  bool check = false, verbose = false;
  std::string html;    ///< a folder; empty: no pages are written
  std::string manual;  ///< where they link to; empty: to pages of it that are written with them
  std::string figures; ///< a folder of what the window drew; empty: none
  bool steps = false;  ///< list steps
  bool force = false;  ///< replace files that are there
};

/// Lists lessons, checks all that they say, or writes them as pages. Returns whether nothing is wrong. Throws
/// Error, Cancelled.
bool runLessons(const LessonsArguments& arguments, std::ostream& out, const Progress& progress);

/// What is given must outlive the parsing; see runLessons() of `isMistaken`.
void addLessons(CLI::App& app, LessonsArguments& lessons, const Progress& progress, bool& isMistaken);

} // namespace taa::cli
