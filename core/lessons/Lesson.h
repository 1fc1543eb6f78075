// Lessons: short text beside a state of the program, claims that hold there, and tasks that it can check.
#pragma once

#include "core/lessons/Condition.h"
#include "core/lessons/LessonState.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace taa {

/// What is asserted of the state that a step sets.
using Claim = Condition;

/// What the reader is asked for.
struct Task {
  std::vector<Condition> conditions; ///< all hold when it is solved, and not all at the start
  std::vector<std::string> hints;    ///< Markdown, one after the other
  LessonState solution;              ///< a state that solves it
};

/// A preset of a ladder, with what it measures in the step's state, which is asserted.
struct Rung {
  std::string preset;   ///< id
  double psnr = 0.0;    ///< dB
  double flicker = 0.0; ///< 0 to ½
  int line = 0;         ///< of the file
};

/// How far from what is said a rung may be: drivers round differently.
inline constexpr double kRungPsnrTolerance = 0.1;     ///< dB
inline constexpr double kRungFlickerTolerance = 0.03; ///< of what is said

struct LessonStep {
  std::string title;
  std::string text; ///< Markdown, without the title and the table of the ladder
  int line = 0;     ///< of its title in the file
  LessonState state;
  std::vector<Claim> claims;
  std::vector<Rung> ladder;
  std::optional<Task> task;
};

struct Lesson {
  std::string id;    ///< of the file's name, "first-ghost"
  std::string place; ///< the file, as messages name it
  std::string title;
  std::string summary;                 ///< Markdown, before the first step
  std::vector<std::string> techniques; ///< rows of the manual that it meets: "11.1", "J9"
  std::vector<LessonStep> steps;
};

/// What a lesson of somebody else's may have.
inline constexpr std::size_t kMaxLessonBytes = 256 * 1024, kMaxLessonSteps = 64, kMaxStepLines = 128;
inline constexpr std::size_t kMaxRungs = 20;
inline constexpr int kMaxLessons = 200;

/// A lesson as Markdown: "# Title", then a step for each "## Title"; what is between ```state and ``` is the
/// step's header of "key: value" lines, and is said on top of the step before. Beside those of
/// lessonKeys() there are claim, rung, task, hint, solution and techniques. `folder` as in applyLessonKey().
/// Throws Error with `place` and the line.
Lesson lessonFromText(const std::string& text, const std::string& place, const std::string& folder = {});

/// The built-in ones, in the order of the course.
const std::vector<Lesson>& builtinLessons();

/// Of a file that nobody has looked at. Throws Error.
Lesson readLesson(const std::filesystem::path& path);

/// Those of a folder, by their names, and what is wrong with those that cannot be read. Throws nothing.
struct LessonFolder {
  std::vector<Lesson> lessons;
  std::vector<std::string> errors;
};
LessonFolder readLessons(const std::filesystem::path& folder);

} // namespace taa
