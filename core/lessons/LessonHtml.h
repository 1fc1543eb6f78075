// Lessons as static pages: what somebody without the program reads.
#pragma once

#include "core/lessons/Lesson.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace taa {

/// Markdown as lessons have it: paragraphs, lists, code, emphasis and links to the web. All else is shown as
/// it is written, so that a text of anybody's is nothing but text.
std::string htmlOfMarkdown(std::string_view markdown);

/// A picture of a step, beside the page.
struct LessonFigure {
  std::string file, caption;
};

/// `figures` of each step. Links to the manual lead to `manual`, a folder or an address; empty: none.
std::string lessonHtml(const Lesson& lesson, const std::vector<std::vector<LessonFigure>>& figures,
                       const std::string& manual);

/// The table of contents, with a link to each lesson's "ID.html".
std::string contentsHtml(const std::vector<Lesson>& lessons);

} // namespace taa
