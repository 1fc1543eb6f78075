// Cones of fog of a frame and of those before it, world space. Filled by C++, read by GLSL.
#ifdef __cplusplus
#pragma once
#include <glm/vec4.hpp>
namespace taa::shared {
using glm::ivec4;
using glm::vec4;
#endif
const int kMaxFogCones = 4;
const int kMaxFogFrames = 16;
#ifdef __cplusplus
struct FogBlock {
#else
layout(std140, binding = 7) uniform FogBlock {
#endif
  ivec4 counts; // cones, frames with this one, steps; w unused
  vec4 march;   // x: distance along the rays at which it starts, m, y: length of a step, m; zw unused
  vec4 light[kMaxFogCones]; // radiance of endless fog at the small end; w: extinction, 1/m
  vec4 shape[kMaxFogCones]; // x: radius of the small end, y: radius gained, z: share of light lost a meter; w: length
  // Of each frame, latest first, kMaxFogCones each.
  vec4 apex[kMaxFogFrames * kMaxFogCones]; // middle of the small end; w: number of the frame for noise
  vec4 axis[kMaxFogFrames * kMaxFogCones]; // along the cone, normalized; w unused
#ifdef __cplusplus
};
} // namespace taa::shared
#else
} fog;
#endif
