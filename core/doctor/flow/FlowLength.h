// By which factors motion that is shorter than a pixel everywhere has to be multiplied to be what squares
// move by: by least squares, with their standard errors.
#pragma once

#include "core/doctor/flow/Flow.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace taa::doctor {

/// Along x and y; an axis along which too little moves has neither.
struct FittedLength {
  std::optional<double> factor[2];
  double error[2] = {0.0, 0.0}; ///< standard error of each, by how much pairs of frames differ
  double given = 0.0,
         fitted = 0.0; ///< mean |luma − luma of the frame before| of squares that move, as given, as measured
  std::size_t squares = 0, pairs = 0; ///< squares that move
  double movesPx = 0.0;               ///< in the mean of these
};

/// Nothing: some motion is longer, or no factor makes what squares move by of it.
std::optional<FittedLength> fittedLength(const std::vector<FlowPair>& pairs);

/// Whether nothing is given of what moves, by what all squares of a pair move by in the middle and in the
/// mean over all pairs: jitter, whichever it is, comes to nothing there.
bool isRestRefuted(const std::vector<FlowPair>& pairs);
/// px: at which motion that is given ends, and what pictures move by there does not; nothing: at none.
/// `tolerancePx`: by which motion may be off.
std::optional<double> limitPx(const std::vector<FlowPair>& pairs, double tolerancePx);

/// The unit that a fitted length is: texture or device coordinates taken for pixels, where the numbers of the
/// picture's size lie within its error; else a trial of the fitted factors.
MotionTrial trialOf(const FittedLength& length, const glm::ivec2& sizePx);

} // namespace taa::doctor
