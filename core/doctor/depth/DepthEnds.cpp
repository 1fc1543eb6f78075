#include "core/doctor/depth/DepthEnds.h"

#include <algorithm>

namespace taa::doctor {

namespace {

/// Of all pixels: so many are an area.
constexpr double kSkyShare = 0.01;
/// Of what is drawn.
constexpr double kMostDrawn = 0.9, kNearlyEverything = 0.98;

} // namespace

void DepthEnds::add(const DoctorFrame& frame) {
  for (std::size_t i = 0; i < frame.depth.pixels.size(); ++i) {
    const float depth = frame.depth.pixels[i];
    if (!frame.objectId.empty() && frame.objectId[i] != 0) {
      ++drawn;
      if (depth == 0.0f) ++drawnAtFar;
    }
    if (depth == 0.0f)
      ++atFar;
    else if (depth == 1.0f)
      ++atNear;
    else if (depth > 0.0f && depth < 1.0f) {
      ++(depth > 0.5f ? nearHalf : farHalf);
      least = std::min(least, depth);
    }
  }
}

bool DepthEnds::isSkyNear() const {
  return atFar == 0 && static_cast<double>(atNear) >= kSkyShare * static_cast<double>(pixels()) && atNear > 0;
}

bool DepthEnds::isAllNear() const {
  return atNear > 0 &&
         static_cast<double>(atNear) >= kNearlyEverything * static_cast<double>(pixels() - atFar);
}

bool DepthEnds::isDrawnFar() const {
  return drawnAtFar > 0 && static_cast<double>(drawnAtFar) >= kNearlyEverything * static_cast<double>(drawn);
}

bool DepthEnds::isTurned() const {
  return isSkyNear() && nearHalf > 0 &&
         static_cast<double>(nearHalf) >= kMostDrawn * static_cast<double>(nearHalf + farHalf);
}

} // namespace taa::doctor
