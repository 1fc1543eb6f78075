// Lessons and the manual as static pages: what somebody without the program reads.
#pragma once

#include "core/lessons/Lesson.h"
#include "core/lessons/LessonNumbers.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace taa {

struct ManualPage;

/// What a link's address becomes; empty: it is no link, and shown as it is written.
using LinkPlace = std::function<std::string(std::string_view address)>;
/// Addresses of the web alone.
std::string webPlace(std::string_view address);

/// CommonMark with tables. Tags are shown as text; pictures, and links that lead nowhere, as
/// "[text](address)". Headings, and rows of tables, that begin with a number of the manual, "11.1", are found
/// by it.
std::string htmlOfMarkdown(std::string_view markdown, const LinkPlace& place = webPlace);

/// A picture of a step, beside the page.
struct LessonFigure {
  std::string file, caption;
  int widthPx = 640; ///< on the page; 0: as the file has it
};

/// What a page shows of a step beside its text.
struct StepOnPage {
  std::vector<LessonFigure> figures{};
  std::vector<LessonNumber> numbers{}; ///< that its text rests on
  std::vector<double> times{};         ///< of its ladder's rungs
};

/// Where a page leads.
struct LessonLinks {
  std::string manual{};           ///< folder or address with "/" at its end; empty: none
  std::string manualEnding{"md"}; ///< of its pages
  const Lesson* before = nullptr; ///< in the course; null: none
  const Lesson* after = nullptr;
};

/// `steps`: as many as the lesson has.
std::string lessonHtml(const Lesson& lesson, const std::vector<StepOnPage>& steps, const LessonLinks& links);

/// The table of contents, with a link to each lesson's "ID.html", and its picture where there is one.
std::string contentsHtml(const std::vector<Lesson>& lessons, const std::vector<std::string>& pictures,
                         const LessonLinks& links);

/// A page of the manual; its links to others lead to "NAME.html" beside it.
std::string manualHtml(const ManualPage& page);

} // namespace taa
