#include "app/models/AlphaSeries.h"

#include "core/probe/SampleWeights.h"

#include <algorithm>

namespace taa::app {

int AlphaSeries::length() const {
  return std::clamp(frame - start + 1, 1, kMaxFramesBack);
}

std::vector<double> AlphaSeries::nominal() const {
  return alphasAtRest(settings, length());
}

} // namespace taa::app
