// A material's factors and texture transforms. Filled by C++, read by GLSL.
#ifdef __cplusplus
#pragma once
#include <glm/vec4.hpp>
namespace taa::shared {
using glm::vec4;
struct MaterialBlock {
#else
layout(std140, binding = 5) uniform MaterialBlock {
#endif
  vec4 baseColor; // linear; w: alpha
  vec4 emissive;  // linear; w: alpha cutoff
  vec4 surface;   // metallic, roughness, normal scale, occlusion strength
  // Two rows for each slot (base color, metallic-roughness, normal, occlusion, emissive): xyz · (u, v, 1) gives
  // the texture coordinate, w of the first row is the uv set.
  vec4 uvRows[10];
  vec4 wind;          // amplitude, wave number, frequency; w unused
  vec4 windDirection; // w unused
#ifdef __cplusplus
};
} // namespace taa::shared
#else
} material;
#endif
