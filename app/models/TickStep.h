// Ticks of an axis with few numbers.
#pragma once

#include "app/models/ChartMath.h"

namespace taa::app {

/// roundStep() of a range, less where fewer than two multiples of it would lie within.
inline double tickStep(const Span& range, int most) {
  constexpr int kTries = 8; // with as many more steps a range that is not empty has two of them
  double step = roundStep(range.length(), most);
  for (int more = 1; more < kTries && ticksOf(range, step).size() < 2; ++more)
    step = roundStep(range.length(), most + more);
  return step;
}

} // namespace taa::app
