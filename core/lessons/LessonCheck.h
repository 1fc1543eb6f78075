// Whether what a lesson says of its states is true: opened, resolved and measured by the program itself.
#pragma once

#include "core/base/Progress.h"
#include "core/lessons/Lesson.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace taa {

class Inspector;

/// Opens the state and goes to its frame. Gives the state on the frames that are open now, which are others
/// where it records some. Throws Error, Cancelled.
LessonState openState(Inspector& inspector, const LessonState& state, const Progress& progress = {});

/// A condition with what was measured of it.
struct CheckedCondition {
  Condition condition;
  double left = 0.0, right = 0.0; ///< NaN: not known in this frame
  bool holds = false;
};

/// "metric psnr > 30: 31.2 > 30"
std::string checkedText(const CheckedCondition& checked);

/// Of the state, which it opens. Throws Error, Cancelled; of a lane that is not there the condition's line.
std::vector<CheckedCondition> checkConditions(Inspector& inspector, const LessonState& state,
                                              const std::vector<Condition>& conditions,
                                              const Progress& progress = {});

bool allHold(const std::vector<CheckedCondition>& checked);

/// What became of one thing that a lesson says.
struct LessonFinding {
  std::string sentence; ///< with file and line
  bool isMistake = false;
};

/// Of a lesson: claims, tasks, which are not solved at the start and are by their solution, and states that
/// cannot be set. Throws Cancelled.
std::vector<LessonFinding> checkLesson(Inspector& inspector, const Lesson& lesson,
                                       const Progress& progress = {});

/// Those of them that are mistakes.
std::vector<std::string> mistakesOf(const std::vector<LessonFinding>& findings);

} // namespace taa
