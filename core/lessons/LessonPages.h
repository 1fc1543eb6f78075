// The course as a folder of pages: a contents page, a page for each lesson with its pictures and clips, and
// the manual.
#pragma once

#include "core/base/Progress.h"
#include "core/lessons/Lesson.h"

#include <filesystem>
#include <string>
#include <vector>

namespace taa {

struct LessonPages {
  std::filesystem::path folder;
  /// Folder or address of the manual that pages link to, with "/" at its end; empty: the manual is written as
  /// pages, too, into "manual" below the folder.
  std::string manual{};
  /// A folder of what only the window draws, "LESSON-STEP-FIGURE.svg" or ".png", as taa-inspector --figure
  /// writes it; empty: there is none.
  std::filesystem::path figures{};
};

/// What of the window a step speaks of, by the names of taa-inspector --figure: "jitter", "color-space";
/// empty: only views.
std::string windowFigure(const LessonStep& step);

/// What lies in the folder when they are written, "index.html" first.
std::vector<std::filesystem::path> lessonPageFiles(const std::vector<Lesson>& lessons,
                                                   const LessonPages& pages);

/// Writes them, over those that are there; pictures are drawn by the core, as views show them, two pixels of
/// the page for one of theirs or as near as the step looks; clips are of steps that play. On threads of its
/// own, which call `progress` one at a time. Throws Error, Cancelled.
void writeLessonPages(const std::vector<Lesson>& lessons, const LessonPages& pages,
                      const Progress& progress = {});

} // namespace taa
