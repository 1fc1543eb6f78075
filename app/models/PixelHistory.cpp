#include "app/models/PixelHistory.h"

#include "core/probe/SampleWeights.h"

#include <algorithm>

namespace taa::app {

int PixelHistory::length() const {
  return std::clamp(frame - start + 1, 1, kMaxFramesBack);
}

std::vector<double> PixelHistory::nominal() const {
  return calmAlphas(settings, length());
}

} // namespace taa::app
