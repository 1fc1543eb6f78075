// taa-batch lessons: what lessons there are, and whether what they say is true.
#include "core/cli/Table.h"
#include "core/cli/lessons/LessonsOptions.h"
#include "core/inspect/Inspector.h"
#include "core/lessons/LessonCheck.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <ostream>

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
  listLessons(lessons, out);
  return true;
}

void addLessons(CLI::App& app, LessonsArguments& lessons, const Progress& progress, bool& isMistaken) {
  CLI::App* command = app.add_subcommand(
      "lessons", "List the lessons, or check what they claim; ends with 3 where something does not hold");
  command->add_option("FILE", lessons.files, "Lessons as Markdown; without any the built-in ones");
  command->add_flag("--check", lessons.check,
                    "Set the state of each step, and say which claims do not hold and which tasks cannot be "
                    "solved as they say");
  command->add_flag("--verbose", lessons.verbose,
                    "With --check: also say what was measured where all is right");
  command->callback(
      [&lessons, &progress, &isMistaken] { isMistaken = !runLessons(lessons, std::cout, progress); });
}

} // namespace taa::cli
