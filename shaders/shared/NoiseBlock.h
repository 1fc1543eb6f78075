// What the noise pass knows besides the frame. Filled by C++, read by GLSL.
#ifdef __cplusplus
#pragma once
#include <glm/vec4.hpp>
namespace taa::shared {
using glm::vec4;
struct NoiseBlock {
#else
layout(std140, binding = 6) uniform NoiseBlock {
#endif
  vec4 terms; // x: amount in scene-linear color, y: frame modulo 256; zw unused
#ifdef __cplusplus
};
} // namespace taa::shared
#else
} noise;
#endif
