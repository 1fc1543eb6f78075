// Every explanation of the motion given against what squares move by: the distance that is left, px, by
// region and frame, beside what is left where nothing is wrong.
#pragma once

#include "core/doctor/flow/Flow.h"
#include "core/doctor/flow/Refuted.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace taa::doctor {

/// Middle distance, px, of what squares move by from what a trial makes of the motion given. `trial`: index
/// into motionTrials(). Infinite where it says nothing of most.
double leftPx(const std::vector<const FlowSquare*>& squares, std::size_t trial);
/// px: that much is left where motion is right, by the quarter of all squares that it fits best.
double healthyPx(const FlowSeen& seen);

/// What an explanation is worth to squares whose motion pictures say.
enum class BorneOut : std::uint8_t {
  Open, ///< there are too few, or it leads nearly where the motion given does
  Yes,
  Partly, ///< it makes what some of them move by
  No,
};
BorneOut borneOut(const std::vector<const FlowSquare*>& squares, std::size_t trial);

/// The explanation that leaves no more than is left where motion is right, where the motion given leaves much
/// more, and those that leave as little; simple ones first. Nothing: there is none. Factors and axes are
/// fitted instead, see explaining(); jitter is smaller than what is asked of squares.
std::vector<std::size_t> bestReadings(const std::vector<const FlowSquare*>& squares,
                                      const std::vector<MotionTrial>& trials, double healthyPx);

} // namespace taa::doctor
