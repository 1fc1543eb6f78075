// What the mesh shader knows of an object: a primitive at a node. Filled by C++, read by GLSL.
#ifdef __cplusplus
#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
namespace taa::shared {
using glm::ivec4;
using glm::mat4;
using glm::vec4;
#endif
struct DrawBlock {
  mat4 worldFromModel;
  mat4 normalFromModel;       // cofactors of worldFromModel, signed so that normals keep their side
  mat4 clipFromModel;         // unjittered
  mat4 previousClipFromModel; // unjittered, of the previous frame
  vec4 previousDepthRow;      // · (position, 1) = view depth in the previous frame, m
  vec4 drawTerms;             // object id, −1 when the transform mirrors else 1, 1 when responsive; w: ObjectClass
  vec4 moments;               // time, previous time, seconds between them; w unused
  vec4 uvCell;                // first uv set: factor, then shift
  ivec4 deform;               // first joint, first morph weight, frame of the cache; w unused
  ivec4 deformCounts;         // morph targets, vertices, way from joints and from weights to the previous ones
};
#ifdef __cplusplus
} // namespace taa::shared
#else
layout(std140, binding = 4) uniform OneDraw { DrawBlock oneDraw; };
layout(std430, binding = 5) readonly buffer Instances { DrawBlock instances[]; }; // one after another as they are drawn
DrawBlock draw; // the object of a vertex
#endif
