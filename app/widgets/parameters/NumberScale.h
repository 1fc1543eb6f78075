// How a number field moves: steps, drags, and the place of a value in its range.
#pragma once

#include <limits>

namespace taa::app {

struct NumberScale {
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  bool isInteger = false;
  double step = 0.0; ///< 0: follows from range or value

  bool isBounded() const;
  /// Positive ranges over two decades or more are moved through by ratio.
  bool isLogarithmic() const;
  double clamped(double value) const;
  /// 0 to 1 in the range; 0 when it has no bounds.
  double fraction(double value) const;
  /// What one step changes at `value`: a power of ten, or `step`.
  double quantum(double value) const;
  /// `value` moved by whole steps, on a multiple of the step.
  double stepped(double value, int steps) const;
  /// `value` dragged by `pixels`: 250 of them cross the range. Not rounded; see rounded().
  double dragged(double value, double pixels) const;
  /// `value` on the nearest multiple of a step (fine: a tenth of one).
  double rounded(double value, bool fine) const;
};

} // namespace taa::app
