// Punctual lights of a frame, world space, after KHR_lights_punctual. Filled by C++, read by GLSL.
#ifdef __cplusplus
#pragma once
#include <glm/vec4.hpp>
namespace taa::shared {
using glm::vec4;
#endif
const int kMaxLights = 64;
#ifdef __cplusplus
struct LightBlock {
#else
layout(std140, binding = 3) uniform LightBlock {
#endif
  vec4 lightPosition[kMaxLights];  // w 1: where it is; w 0: direction to it, normalized
  vec4 lightDirection[kMaxLights]; // along its beam, normalized; w unused
  vec4 lightColor[kMaxLights];     // lux (w of the position 0) or candela; w unused
  vec4 lightTerms[kMaxLights];     // cone scale, cone offset, 1/range² (0: unlimited); w unused
#ifdef __cplusplus
};
} // namespace taa::shared
#else
} lighting;
#endif
