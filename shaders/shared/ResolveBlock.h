// What the resolve knows of a frame besides its textures and settings. Filled by C++, read by GLSL.
#ifdef __cplusplus
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
namespace taa::shared {
using glm::ivec2;
using glm::ivec4;
using glm::vec2;
using glm::vec4;
struct ResolveBlock {
#else
layout(std140, binding = 0) uniform ResolveBlock {
#endif
  vec2 sizePx;          // width, height of the picture and of history
  vec2 jitterPx;        // displacement of image content in render px, x right, y down
  vec2 renderSizePx;    // width, height of the inputs
  vec2 renderRatio;     // renderSizePx / sizePx
  vec4 depthTerms;      // (P33, P32, P23, P22): view depth = (d·P33 − P32) / (d·P23 − P22)
  vec4 currentWeights0; // weights of the current filter, row-major over 3×3: first row, w unused
  vec4 currentWeights1; // middle row
  vec4 currentWeights2; // last row
  vec4 weightTerms;     // x: factor on α by the sample's distance; y: eighths of the reference frame that this one took
  ivec4 state;          // x: bit 0 when there is history, others for its layers; y, z: pixel at the target's top left; w: the frame's number
  ivec4 spread;         // pixels of the region that is drawn, texels of the target that stand for them
#ifdef __cplusplus
};
} // namespace taa::shared
#else
} resolveBlock;
#endif
