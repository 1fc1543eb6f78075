// What the scene shaders know of a frame: matrices, jitter, sky and lights' count. Filled by C++, read by GLSL.
// Spaces: world → view (looks along −z) → clip (y up, depth reversed 0…1, far plane at infinity).
#ifdef __cplusplus
#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
namespace taa::shared {
using glm::mat4;
using glm::vec2;
using glm::vec4;
struct FrameBlock {
#else
layout(std140, binding = 2) uniform FrameBlock {
#endif
  mat4 clipFromWorld;         // unjittered
  mat4 jitteredClipFromWorld; // T(2jx/W, −2jy/H) · clipFromWorld, or as jitter.projection says
  mat4 worldFromJitteredClip; // its inverse
  mat4 viewFromWorld;
  mat4 previousClipFromWorld; // unjittered, of the previous frame
  mat4 previousViewFromWorld;
  mat4 previousClipFromClip; // from one picture to the other, both unjittered; exactly 1 when the camera rests
  vec2 sizePx;       // width, height of what is drawn
  vec2 jitterPx;     // displacement of image content, x right, y down
  vec4 cameraPosition; // world; w: 1 when orthographic
  vec4 depthTerms;   // projection elements (P33, P32, P23, P22): view depth = (d·P33 − P32) / (d·P23 − P22)
  vec4 skyZenith;    // radiance
  vec4 skyHorizon;
  vec4 skyGround;
  vec4 sunDirection; // to the sun, normalized; w: 1 when it shines
  vec4 sunColor;     // irradiance
  vec4 storage;      // x: 1 when color and motion are kept as 16-bit floats; yzw unused
  vec4 textures;     // x: bias of the level of detail, y: 2 to its power, z: frame modulo 16; w unused
  vec4 previousJitter; // xy: jitterPx of the previous frame; zw unused
  vec4 printedJitter; // added to clip x and y by another projection than the translation: xy of w and zw of z
#ifdef __cplusplus
};
} // namespace taa::shared
#else
} frame;
#endif
