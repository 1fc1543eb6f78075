// By which factor motion that is shorter than a pixel everywhere has to be multiplied for pictures to fit it:
// fitted by least squares, with its standard error.
#pragma once

#include "core/base/Image.h"
#include "core/doctor/motion/MotionTrials.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace taa::doctor {

/// Along x and y; an axis along which too little moves has neither.
struct FittedLength {
  std::optional<double> factor[2];
  double error[2] = {0.0, 0.0}; ///< standard error of each, by how much pairs of frames differ
  double given = 0.0,
         fitted = 0.0; ///< mean |luma − luma of the frame before| of what moves, as given, fitted
  std::size_t pixels = 0, pairs = 0;
  double movesPx = 0.0; ///< by the fit, in the mean of these pixels
};

/// Pairs of frames as far as the length of motion is asked of them.
class LengthEvidence {
 public:
  void add(const FrameNeighbors& frames);
  /// Nothing: some motion is longer, or no factor makes pictures fit clearly better.
  std::optional<FittedLength> fit() const;

 private:
  struct Pixel {
    glm::dvec2 place{0.0}; ///< in the frame before if nothing moves, px
    glm::dvec2 motionPx{0.0};
    double luma = 0.0;
  };
  struct Pair {
    std::vector<Pixel> pixels; ///< with detail, and with motion
    Image previousLuma;
  };
  class Fitting;

  std::vector<Pair> pairs_;
  std::size_t known_ = 0, longer_ = 0; ///< pixels of all pairs; with motion of a pixel or more
};

/// The unit that a fitted length is: texture or device coordinates taken for pixels, where the numbers of the
/// picture's size lie within its error; else a trial of the fitted factors.
MotionTrial trialOf(const FittedLength& length, const glm::ivec2& sizePx);

} // namespace taa::doctor
