// What the mesh shader knows of the sun's shadows. Filled by C++, read by GLSL.
// The map: depth as the sun sees it, reversed as everywhere, by an orthographic picture.
#ifdef __cplusplus
#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
namespace taa::shared {
using glm::mat4;
using glm::vec4;
struct ShadowBlock {
#else
layout(std140, binding = 9) uniform ShadowBlock {
#endif
  mat4 mapFromWorld; // x, y: texels, row 0 the top; z: depth
  vec4 lowest;       // of what casts shadows, world; w: m of a depth of 1
  vec4 highest;      // likewise; w: m that a thing must be before a surface, so that it is not the surface itself
  vec4 toSun;        // normalized; w: number of the noise
  vec4 aside;        // x, y: texels that a ray to the rim of the sun goes aside in 1 m, z: rays, w: texels of a side
#ifdef __cplusplus
};
} // namespace taa::shared
#else
} shadow;
#endif
