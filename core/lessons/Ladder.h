// The ladder of a step as a table: what each rung is, what it gains and what it costs.
#pragma once

#include "core/base/Progress.h"
#include "core/lessons/Lesson.h"

#include <string>
#include <string_view>
#include <vector>

namespace taa {

class Inspector;

/// What a link to a rung begins with, before the id of its preset.
inline constexpr std::string_view kRungScheme = "rung";

struct LadderColumns {
  std::vector<double> times{}; ///< of each rung, see measureTimes(); empty: no column
  bool isLinked = false;       ///< each rung's name leads to it
};
/// Markdown: a row for each rung with PSNR, flicker, the texture fetches of a pixel and, where it was
/// measured, the time. Empty without a ladder.
std::string ladderMarkdown(const std::vector<Rung>& ladder, const LadderColumns& columns = {});

/// How many times as long the resolve takes with each rung as with the first. In an early frame of the state:
/// what a pixel costs does not depend on how long its history is. Throws Error, Cancelled.
std::vector<double> measureTimes(Inspector& inspector, const LessonState& step,
                                 const std::vector<Rung>& ladder, const Progress& progress = {});

} // namespace taa
