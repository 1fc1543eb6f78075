// What no intermediate holds but formulas and plots of a pixel are made of.
#pragma once

#include "core/taa/twin/Stages.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <memory>

namespace taa::twin {

struct Trace;

struct Details {
  glm::ivec2 texel{0};                      ///< the drawn one that the pixel looks at
  Neighborhood neighborhood;                ///< with the nine samples
  WeightInputs weighed;                     ///< what the terms of α looked at
  std::array<float, 9> filterWeights{};     ///< of the current filter, not normalized; 0: not of 3×3
  std::array<glm::vec3, 9> filterSamples{}; ///< what they weigh, scene-linear
  Taps historyTaps;                         ///< none: there is no history
  Taps upsampleTaps;                        ///< none: drawn at full size, or of the nearest sample alone
  glm::vec2 sampleOffset{0.0f}, renderRatio{1.0f}; ///< render px, from the pixel's center; render px per px
  LockState lockState;                             ///< what is taken back of the correction, and why
  Geometry geometry;
  GeometryMatch match;
  Divergence divergence;
  bool isFirst = true; ///< there is no history
  glm::vec2 jitterPx{0.0f};
  glm::ivec2 picturePx{0};
  glm::vec2 readPosition{0.0f};       ///< px, where history was read
  std::shared_ptr<const Trace> trace; ///< how everything was made; null: not asked for
};

} // namespace taa::twin
