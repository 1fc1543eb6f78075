// Depth of now against that of history, on the CPU (manual 12.1, 13.9).
#pragma once

#include "core/taa/twin/SampleStages.h"

#include <glm/vec2.hpp>

namespace taa::twin {

/// Sum of the depth steps along the surface at a render texel, m.
float depthSlope(const Inputs& inputs, const glm::ivec2& drawn);

struct DepthTest {
  float expected = 0.0f;  ///< m
  float stored = 0.0f;    ///< m, the one that fits best
  float mismatch = 0.0f;  ///< relative to the one expected
  float allowed = 0.0f;   ///< the largest mismatch of the same surface
  bool isOther = false;   ///< another surface
  bool isFlicker = false; ///< not another one, though its depth differs
};
/// `drawn`: the render texel; `position`: where history is read, px.
DepthTest compareDepth(const Inputs& inputs, const ValidateSettings& settings, const DilatedMotion& dilated,
                       const glm::ivec2& drawn, const glm::vec2& position);

} // namespace taa::twin
