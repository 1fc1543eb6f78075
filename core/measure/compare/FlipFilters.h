// The filters of FLIP (Flip.h): what the eye resolves, and what it takes for an edge and a point.
#pragma once

#include "core/measure/compare/Plane.h"

namespace taa {

struct FlipFilters {
  explicit FlipFilters(double pixelsPerDegree);

  FilterWeights achromatic, redGreen;       ///< along rows and columns
  FilterWeights blueYellow, blueYellowTail; ///< the filter is the sum of what both give
  // Along one axis; `smooth` along the other.
  FilterWeights smooth, edge, point;
  int radius = 0; ///< of the widest, px
};

} // namespace taa
