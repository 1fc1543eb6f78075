// taa-batch lessons: what lessons there are, whether what they say is true, and they as pages.
#include "core/base/ExistingFiles.h"
#include "core/cli/LessonsOptions.h"
#include "core/cli/ShotOptions.h"
#include "core/cli/Table.h"
#include "core/inspect/Inspector.h"
#include "core/lessons/LessonCheck.h"
#include "core/lessons/LessonPages.h"

#include <CLI/CLI.hpp>

#include <cstddef>
#include <filesystem>
#include <iostream>
#include <ostream>
#include <string>
#include <vector>

namespace taa::cli {

namespace {

std::vector<Lesson> lessonsOf(const LessonsArguments& arguments) {
  if (arguments.files.empty()) return builtinLessons();
  std::vector<Lesson> lessons;
  for (const std::string& file : arguments.files) lessons.push_back(readLesson(file));
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

} // namespace

bool runLessons(const LessonsArguments& arguments, std::ostream& out, const Progress& progress) {
  const std::vector<Lesson> lessons = lessonsOf(arguments);
  if (arguments.check) return checkLessons(lessons, arguments.verbose, out, progress);
  if (arguments.html.empty()) {
    arguments.steps ? listSteps(lessons, out) : listLessons(lessons, out);
    return true;
  }
  const std::string& manualUrl = arguments.manual;
  const LessonPages pages{arguments.html, manualUrl, arguments.figures};
  const std::vector<std::filesystem::path> files = lessonPageFiles(lessons, pages);
  if (!arguments.force) refuseToReplace(files);
  Inspector inspector;
  writeLessonPages(inspector, lessons, pages, progress);
  for (const std::filesystem::path& file : files) out << file.string() << '\n';
  return true;
}

void addLessons(CLI::App& app, LessonsArguments& lessons, const Progress& progress, bool& isMistaken) {
  CLI::App* command = app.add_subcommand(
      "lessons",
      "List the lessons, check what they claim, or write them as pages; ends with 3 where something does not "
      "hold");
  command->add_option("FILE", lessons.files, "Lessons as Markdown; without any the built-in ones");
  command->add_flag("--check", lessons.check,
                    "Set the state of each step, and say which claims do not hold and which tasks cannot be "
                    "solved as they say");
  command->add_flag("--verbose", lessons.verbose,
                    "With --check: also say what was measured where all is right");
  command
      ->add_option(
          "--html", lessons.html,
          "Write them into this folder as pages with pictures, clips and the manual, which need no program")
      ->type_name("FOLDER");
  command->add_option(
      "--manual", lessons.manual,
      "With --html: folder or address of the manual that pages link to, with / at its end; without it "
      "the manual becomes pages, too");
  command
      ->add_option("--figures", lessons.figures,
                   "With --html: folder of figures that the window drew, LESSON-STEP-FIGURE.svg or .png; "
                   "app/lesson-pages makes them")
      ->type_name("FOLDER");
  command->add_flag("--steps", lessons.steps,
                    "List steps in place of lessons, with what the window draws of each");
  addForce(*command, lessons.force);
  command->callback(
      [&lessons, &progress, &isMistaken] { isMistaken = !runLessons(lessons, std::cout, progress); });
}

} // namespace taa::cli
