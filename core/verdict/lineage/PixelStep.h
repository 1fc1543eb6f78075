// What one pixel of one frame was mixed from: a step of its lineage.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

namespace taa {

/// A texel of the history that a pixel read.
struct HistoryRead {
  glm::ivec2 texel{0};
  double weight = 0.0;   ///< of the filter, which sum up to 1 unless it is one that is printed otherwise
  glm::dvec3 color{0.0}; ///< stored there, scene-linear: what that pixel of the frame before became
};

/// A texel of what was drawn of this frame, as the filter of the current color weighs it.
struct SampleRead {
  glm::ivec2 texel{0};
  double weight = 0.0;
  glm::dvec2 offset{0.0}; ///< px of the picture, from the pixel's center to where the sample lies
};

/// out = α·current + (1 − α)·rectified history, and what the history was read from.
struct PixelStep {
  glm::dvec3 alpha{1.0};            ///< share of the current color in each channel, as it was mixed
  double rectified = 0.0;           ///< share of history that rectification replaced, 0 to 1
  std::vector<HistoryRead> history; ///< none: history starts here
  std::vector<SampleRead> samples;
  glm::dvec3 current{0.0};         ///< filtered, scene-linear
  glm::dvec3 resolved{0.0};        ///< what the pixel became
  glm::dvec2 historyPosition{0.0}; ///< px of the frame before, where history was read
  double scale = 1.0;         ///< how much larger its surface is shown than a frame before, along each axis
  double historyLength = 1.0; ///< N
  int object = 0;             ///< whose motion it follows; 0: the sky
  int sampled = 0;            ///< object that the middle one of its samples is of; 0: the sky
};

} // namespace taa
