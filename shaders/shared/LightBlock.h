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
  // Directional lights first, then point and spot lights; w is unused in all of them.
  vec4 lightPosition[kMaxLights];  // of point and spot lights
  vec4 lightDirection[kMaxLights]; // along its beam, normalized
  vec4 lightColor[kMaxLights];     // lux (directional) or candela
  vec4 lightTerms[kMaxLights];     // of point and spot lights: cone scale, cone offset, 1/range² (0: unlimited)
#ifdef __cplusplus
};
} // namespace taa::shared
#else
} lighting;
#endif
