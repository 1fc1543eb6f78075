// What the visualizer's shader knows of a view: which part of which layer, and how values become colors.
// Filled by C++, read by GLSL.
#ifdef __cplusplus
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
namespace taa::shared {
using glm::ivec4;
using glm::vec2;
using glm::vec4;
struct ViewBlock {
#else
layout(std140, binding = 3) uniform ViewBlock {
#endif
  vec2 sizePx;   // width, height of the picture
  vec2 originPx; // picture position at the top-left corner of the viewport
  vec4 range;    // x: lowest value shown, y: highest minus lowest, z: factor of the exposure, w: screen px a picture px
  ivec4 channels; // x, y, z: 1 where red, green, blue are shown; w unused
  ivec4 layer;    // x: of the texture, y: channel of it that is the first of the row; z, w: of what is subtracted
  ivec4 overlays; // x, y: layer and channel of the reject reason; z, w: of the object id
  vec4 above;     // xyz: color of what lies above the range, linear; w: screen px a unit of hatches, lines and arrows
  vec4 below;     // xyz: color of what lies below the range, linear; w: share of a tint
  vec4 arrows;    // units: x: from one to the next at least, y: a cell at most; z: half the longest, share of its cell;
                  // w: half the shortest that is no dot
  vec4 nothing;   // x, y: light of the grays of the checkers over what has no value, linear; z: side of one, units;
                  // w unused
#ifdef __cplusplus
};
} // namespace taa::shared
#else
} view;
#endif
