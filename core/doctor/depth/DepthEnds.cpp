#include "core/doctor/depth/DepthEnds.h"

#include <algorithm>

namespace taa::doctor {

namespace {

/// Of all pixels: so many are an area.
constexpr double kSkyShare = 0.01;
/// Of what is drawn.
constexpr double kMostDrawn = 0.9;

} // namespace

void DepthEnds::add(const DoctorFrame& frame) {
  for (const float depth : frame.depth.pixels) {
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

bool DepthEnds::isTurned() const {
  return isSkyNear() && nearHalf > 0 &&
         static_cast<double>(nearHalf) >= kMostDrawn * static_cast<double>(nearHalf + farHalf);
}

} // namespace taa::doctor
