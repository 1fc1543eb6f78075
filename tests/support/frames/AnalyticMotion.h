// What motion every pixel of a frame must have, from the formulas of manual 3.3 to 3.7 in double
// precision.
#pragma once

#include "core/render/FrameInputs.h"
#include "core/scene/Scene.h"

#include <string>

namespace taa::test {

/// How a drawn frame agrees with the analytic projection.
struct MotionAgreement {
  int compared = 0;       ///< pixels well inside the triangle that is nearest there
  double worstPx = 0.0;   ///< largest difference of the two motion vectors
  double fastestPx = 0.0; ///< longest analytic motion that was compared
  std::string worst;      ///< where that was, and both vectors
};

/// Follows the sample of each pixel through its triangle: clip positions of the three vertices now and in the
/// frame before, weighted by where the sample lies among them (rule 1 of manual §3). Expects RG32F motion.
MotionAgreement compareMotion(const Scene& scene, const FrameInputs& inputs);

} // namespace taa::test
