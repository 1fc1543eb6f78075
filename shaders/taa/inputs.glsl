// What the resolve reads: this frame's inputs and the history, all of one size, row 0 at the top. Nothing is
// filtered by a sampler, because those round differently from driver to driver and from CPU to CPU.

#include "include/color_spaces.glsl"
#include "shared/ResolveBlock.h"

layout(binding = 0) uniform sampler2D u_color;          // scene-linear, jittered
layout(binding = 1) uniform sampler2D u_depth;          // device depth, reversed, 0 = sky
layout(binding = 2) uniform sampler2D u_motion;         // px, current − previous
layout(binding = 3) uniform sampler2D u_normal;         // world space
layout(binding = 4) uniform usampler2D u_objectId;      // 0 = sky
layout(binding = 5) uniform sampler2D u_previousDepth;  // view depth in the previous frame, m
layout(binding = 6) uniform sampler2D u_historyColor;   // scene-linear
layout(binding = 7) uniform sampler2D u_historySurface; // history length N, view depth in m
layout(binding = 14) uniform sampler2D u_mask;          // reactive, responsive; one black texel when none is drawn
layout(binding = 15) uniform sampler2D u_overlay;       // premultiplied, not jittered; likewise

/// The nearest texel of the picture.
ivec2 clamped(ivec2 texel) { return clamp(texel, ivec2(0), ivec2(resolveBlock.sizePx) - 1); }

/// The same texel as texelFetch at clamped(texel): the samplers are nearest and clamp to the edge, and a texel's center
/// is far from its borders. llvmpipe reads so in half the time.
vec4 texelAt(sampler2D picture, ivec2 texel) {
  return textureLod(picture, (vec2(texel) + 0.5) * (1.0 / resolveBlock.sizePx), 0.0);
}

bool hasHistory() { return resolveBlock.state.x != 0; }

/// View depth in m of a device depth; 0 stands for the sky.
float viewDepth(float depth) {
  precise float numerator = depth * resolveBlock.depthTerms.x - resolveBlock.depthTerms.y;
  precise float denominator = depth * resolveBlock.depthTerms.z - resolveBlock.depthTerms.w;
  precise float result = depth == 0.0 ? 0.0 : numerator / denominator;
  return result;
}

/// This frame's sane colors around a pixel, 3×3 row-major: 4 is the pixel itself.
struct Samples {
  vec3 color[9];
  vec2 mask; // of the pixel: reactive, responsive; read where a stage uses it
};

const bool kUsesMask = kNeighborhoodMaskRelax || kWeightMask != kWeightMask_off;

Samples readInputs(ivec2 pixel) {
  Samples samples;
  for (int k = 0; k < 9; ++k) {
    samples.color[k] = sanitized(texelAt(u_color, pixel + ivec2(k % 3 - 1, k / 3 - 1)).rgb);
  }
  samples.mask = kUsesMask ? texelAt(u_mask, pixel).rg : vec2(0.0);
  expose_color(texelFetch(u_color, pixel, 0).rgb);
  expose_depth(texelFetch(u_depth, pixel, 0).r);
  expose_depthView(viewDepth(texelFetch(u_depth, pixel, 0).r));
  expose_motion(texelFetch(u_motion, pixel, 0).rg);
  expose_normal(texelFetch(u_normal, pixel, 0).xyz);
  expose_objectId(float(texelFetch(u_objectId, pixel, 0).r));
  expose_reactive(texelAt(u_mask, pixel).r);
  expose_responsive(texelAt(u_mask, pixel).g);
  expose_overlay(texelAt(u_overlay, pixel).rgb);
  expose_overlayAlpha(texelAt(u_overlay, pixel).a);
  return samples;
}

/// The color kept within the nine.
vec3 boundedBySamples(vec3 color, Samples samples) {
  vec3 lowest = samples.color[0];
  vec3 highest = samples.color[0];
  for (int k = 1; k < 9; ++k) {
    lowest = lesser(lowest, samples.color[k]);
    highest = greater(highest, samples.color[k]);
  }
  return bounded(color, lowest, highest);
}
