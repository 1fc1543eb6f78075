// What is wrong with the planes of a frame. Filled by C++, read by GLSL.
#ifdef __cplusplus
#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
namespace taa::shared {
using glm::ivec4;
using glm::mat4;
using glm::vec4;
struct FaultBlock {
#else
layout(std140, binding = 8) uniform FaultBlock {
#endif
  mat4 wrongPreviousClipFromWorld; // unjittered: the camera that motion is made with in place of the previous one
  vec4 jitter;      // xy: of this frame, zw: of the last one, px, as they are drawn
  vec4 motionTerms; // xy: factors on motion, zw: shares of jitter.xy and −jitter.zw that are left in it
  ivec4 motionForm; // x: whose motion, y: unit, z: 1 when axes are swapped, w: 1 when 0 is no previous position
  ivec4 texels;     // x: shift of motion, y: side of motion's texel, z: side of depth's texel; w: 1: the camera's motion is there twice
  ivec4 place;      // x: region, y: number of the object; zw: texel that is NaN, negative: none
  vec4 rectangle;   // px: left, top, right, bottom
  vec4 colorTerms;  // x: factor on color, y: interface, z: factor on view depth; w: which depth there is
#ifdef __cplusplus
};
} // namespace taa::shared
#else
} fault;
#endif
