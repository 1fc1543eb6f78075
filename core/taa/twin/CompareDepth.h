// Depth of now against that of history, on the CPU (manual 12.1, 13.9).
#pragma once

#include "core/taa/twin/SampleStages.h"

#include <glm/vec2.hpp>

namespace taa::twin {

/// Sum of the depth steps along the surface at a render texel, m.
template <typename Real = float>
Real depthSlope(const Inputs& inputs, const glm::ivec2& drawn);

template <typename Real>
struct DepthTestOf {
  Real expected = 0.0f;   ///< m
  Real stored = 0.0f;     ///< m, the one that fits best
  Real mismatch = 0.0f;   ///< relative to the one expected
  Real allowed = 0.0f;    ///< the largest mismatch of the same surface
  bool isOther = false;   ///< another surface
  bool isFlicker = false; ///< not another one, though its depth differs
};
using DepthTest = DepthTestOf<float>;
/// `drawn`: the render texel; `position`: where history is read, px.
template <typename Real = float>
DepthTestOf<Real> compareDepth(const Inputs& inputs, const ValidateSettings& settings,
                               const DilatedMotionOf<Real>& dilated, const glm::ivec2& drawn,
                               const Vec2<Real>& position);

} // namespace taa::twin
