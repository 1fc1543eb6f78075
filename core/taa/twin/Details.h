// What no intermediate holds but formulas and plots of a pixel are made of.
#pragma once

#include "core/taa/twin/Stages.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>

namespace taa::twin {

struct Details {
  glm::ivec2 texel{0};                      ///< the drawn one that the pixel looks at
  Neighborhood neighborhood;                ///< with the nine samples
  WeightInputs weighed;                     ///< what the terms of α looked at
  std::array<float, 9> filterWeights{};     ///< of the current filter, not normalized; 0: not of 3×3
  std::array<glm::vec3, 9> filterSamples{}; ///< what they weigh, scene-linear
  glm::vec3 unsharpened{0.0f};              ///< this frame's color, filtered only
  Taps historyTaps;                         ///< none: there is no history
  Taps upsampleTaps;                        ///< none: drawn at full size, or of the nearest sample alone
  glm::vec2 sampleOffset{0.0f}, renderRatio{1.0f}; ///< render px, from the pixel's center; render px per px
  glm::vec2 drawnMotion{0.0f};                     ///< the dilated one, render px
  LockState lockState;                             ///< what is taken back of the correction, and why
  Geometry geometry;
  GeometryMatch match;
  Divergence divergence;
  std::array<glm::vec3, 9> resolvedAround{}; ///< what sharpening looks at
  ShownColor shown;                          ///< nothing where the whole resolved picture is not known
  float slope = 0.0f;         ///< m, what validation takes for the surface's slope over a texel
  bool isFirst = true;        ///< there is no history
  glm::vec4 depthTerms{0.0f}; ///< (P33, P32, P23, P22)
  glm::vec2 jitterPx{0.0f};
  glm::ivec2 picturePx{0};
  glm::vec2 readPosition{0.0f}; ///< px, where history was read
};

} // namespace taa::twin
