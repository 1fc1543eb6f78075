// taa-batch lessons: what lessons there are, whether what they say is true, and they as pages.
#include "core/base/ExistingFiles.h"
#include "core/cli/Command.h"
#include "core/cli/Options.h"
#include "core/cli/Table.h"
#include "core/inspect/Inspector.h"
#include "core/lessons/LessonCheck.h"
#include "core/lessons/LessonPages.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

namespace taa::cli {

namespace {

struct LessonsCommand final : Command {
  std::vector<std::string> files; ///< Markdown; empty: the built-in ones
  bool checks = false, verbose = false;
  std::string html;    ///< a folder; empty: no pages are written
  std::string manual;  ///< where they link to; empty: to pages of it that are written with them
  std::string figures; ///< a folder of what the window drew; empty: none
  bool listsSteps = false;
  bool force = false;

  LessonsCommand() : Command("lessons") {
    description("List the lessons, check what they claim, or write them as pages; ends with 3 where "
                "something does not hold");
    add_option("FILE", files, "Lessons as Markdown; without any the built-in ones");
    add_flag("--check", checks,
             "Set the state of each step, and say which claims do not hold and which tasks cannot be solved "
             "as they say");
    add_flag("--verbose", verbose, "With --check: also say what was measured where all is right");
    add_option(
        "--html", html,
        "Write them into this folder as pages with pictures, clips and the manual, which need no program")
        ->type_name("FOLDER");
    add_option("--manual", manual,
               "With --html: folder or address of the manual that pages link to, with / at its end; without "
               "it the manual becomes pages, too");
    add_option("--figures", figures,
               "With --html: folder of figures that the window drew, LESSON-STEP-FIGURE.svg or .png; "
               "app/lesson-pages makes them")
        ->type_name("FOLDER");
    add_flag("--steps", listsSteps, "List steps in place of lessons, with what the window draws of each");
    addForce(*this, force);
  }

  int run(std::ostream& out, const Progress& progress) const override;
};

std::vector<Lesson> lessonsOf(const std::vector<std::string>& files) {
  if (files.empty()) return builtinLessons();
  std::vector<Lesson> lessons;
  for (const std::string& file : files) lessons.push_back(readLesson(file));
  return lessons;
}

void listLessons(const std::vector<Lesson>& lessons, std::ostream& out) {
  std::vector<std::vector<std::string>> table{{"ID", "STEPS", "TITLE"}};
  for (const Lesson& lesson : lessons)
    table.push_back({lesson.id, std::to_string(lesson.steps.size()), lesson.title});
  printTable(out, table);
}

/// What the window draws of a step stands between, "-" where that is nothing.
void listSteps(const std::vector<Lesson>& lessons, std::ostream& out) {
  std::vector<std::vector<std::string>> table{{"ID:STEP", "FIGURE", "TITLE"}};
  for (const Lesson& lesson : lessons)
    for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
      const std::string figure = windowFigure(lesson.steps[step]);
      table.push_back({lesson.id + ":" + std::to_string(step + 1), figure.empty() ? "-" : figure,
                       lesson.steps[step].title});
    }
  printTable(out, table);
}

/// Each lesson's lines come when it is done.
bool checkLessons(const std::vector<Lesson>& lessons, bool isVerbose, std::ostream& out,
                  const Progress& progress) {
  Inspector inspector;
  bool areRight = true;
  for (const Lesson& lesson : lessons) {
    const std::vector<LessonFinding> findings = checkLesson(inspector, lesson, progress);
    const bool isRight = mistakesOf(findings).empty();
    for (const LessonFinding& finding : findings)
      if (finding.isMistake || isVerbose) out << finding.sentence << '\n';
    if (isRight) out << lesson.place << ": right, " << lesson.steps.size() << " steps\n";
    out << std::flush;
    areRight = areRight && isRight;
  }
  return areRight;
}

int LessonsCommand::run(std::ostream& out, const Progress& progress) const {
  const std::vector<Lesson> lessons = lessonsOf(files);
  if (checks) return checkLessons(lessons, verbose, out, progress) ? kDone : kFindings;
  if (html.empty()) {
    listsSteps ? listSteps(lessons, out) : listLessons(lessons, out);
    return kDone;
  }
  const LessonPages pages{html, manual, figures};
  const std::vector<std::filesystem::path> written = lessonPageFiles(lessons, pages);
  if (!force) refuseToReplace(written);
  writeLessonPages(lessons, pages, progress);
  for (const std::filesystem::path& file : written) out << file.string() << '\n';
  return kDone;
}

} // namespace

std::shared_ptr<Command> lessonsCommand() {
  return std::make_shared<LessonsCommand>();
}

} // namespace taa::cli
