// What a step's text rests on, in numbers: all that its claims speak of, measured of what is open and of the
// settings that it is compared with.
#pragma once

#include "core/base/Progress.h"
#include "core/lessons/Condition.h"
#include "core/lessons/Lesson.h"
#include "core/lessons/LessonCheck.h"
#include "core/lessons/LessonState.h"

#include <string>
#include <vector>

namespace taa {

class Inspector;

/// The quantities that `conditions` measure, each once, in their order, without lane and arithmetic. What is
/// answered by yes or no, a verdict or a finding of the doctor, is none.
std::vector<Quantity> measuredQuantities(const std::vector<Condition>& conditions);

/// Whether its claims have numbers that may be told: those of a step with a task could tell its solution.
bool hasNumbers(const LessonStep& step);

/// A quantity of a state itself and of its lanes.
struct LessonNumber {
  std::string label;          ///< "PSNR, dB", "History position X at 100, 60, px"
  std::vector<double> values; ///< of the state, then of each lane in order; NaN: not known
};

/// Of the state, which it opens. Throws Error, Cancelled.
std::vector<LessonNumber> measureNumbers(Inspector& inspector, const LessonState& state,
                                         const std::vector<Condition>& conditions,
                                         const Progress& progress = {});

/// Those as Markdown: a table with a column for the state, called `first`, and one for each of its lanes,
/// then in which settings these differ from the step's own. Empty where there are no numbers.
std::string numbersMarkdown(const std::vector<LessonNumber>& numbers, const LessonState& step,
                            const std::string& first);

/// What a condition lacks, for a reader: "PSNR, dB: 28.41, asked for: more than 31.2". `space` names the
/// channels of boxes.
std::string lackText(const CheckedCondition& checked, const SpaceSettings& space);

} // namespace taa
