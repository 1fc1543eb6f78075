// What the resolve reads: this frame's inputs, of the render size, and the history, of the picture's, row 0 at the
// top. Nothing is filtered by a sampler, because those round differently from driver to driver and from CPU to CPU.

#include "include/color_spaces.glsl"
#include "shared/ResolveBlock.h"

layout(binding = 0) uniform sampler2D u_color;          // scene-linear, jittered
layout(binding = 1) uniform sampler2D u_depth;          // device depth, reversed, 0 = sky
layout(binding = 2) uniform sampler2D u_motion;         // render px, current − previous
layout(binding = 3) uniform sampler2D u_normal;         // world space; alpha: class of the object
layout(binding = 4) uniform usampler2D u_objectId;      // 0 = sky
layout(binding = 5) uniform sampler2D u_previousDepth;  // view depth in the previous frame, m
layout(binding = 6) uniform sampler2D u_historyColor;   // scene-linear
layout(binding = 7) uniform sampler2D u_historySurface; // history length N, view depth in m
// Bound where the settings need them (core/taa/History.h).
layout(binding = 8) uniform sampler2D u_historyObject; // number, class
layout(binding = 9) uniform sampler2D u_historyNormal; // world space
layout(binding = 10) uniform sampler2D u_historyMotion; // px
layout(binding = 11) uniform sampler2D u_historyLock;   // life, luma
layout(binding = 12) uniform sampler2D u_historyLumas;  // of the last four frames, latest first
layout(binding = 13) uniform sampler2D u_fog;           // scattered light, opacity; one black texel when there is none
layout(binding = 14) uniform sampler2D u_mask;          // reactive, responsive; one black texel when none is drawn
layout(binding = 15) uniform sampler2D u_overlay;       // premultiplied, not jittered; likewise
layout(binding = 16) uniform sampler2D u_forwardCount;  // pixels of the last frame; one texel of −1 when not counted

/// Motion that says there is no previous position: the largest half float.
const float kNoPreviousPosition = 65504.0;

/// The nearest texel of the inputs.
ivec2 clampedToDrawn(ivec2 texel) { return clamp(texel, ivec2(0), ivec2(resolveBlock.renderSizePx) - 1); }

/// The same texel of an input as texelFetch at clamped(texel): the samplers are nearest and clamp to the edge, and a
/// texel's center is far from its borders. llvmpipe reads so in half the time.
vec4 texelAt(sampler2D picture, ivec2 texel) {
  return textureLod(picture, (vec2(texel) + 0.5) * (1.0 / resolveBlock.renderSizePx), 0.0);
}

/// Likewise of a history.
vec4 historyAt(sampler2D picture, ivec2 texel) {
  return textureLod(picture, (vec2(texel) + 0.5) * (1.0 / resolveBlock.sizePx), 0.0);
}

// What resolveBlock packs.
int historyFlags() { return resolveBlock.state.x; }
int frameNumber() { return resolveBlock.state.w; }
ivec2 firstPixel() { return resolveBlock.state.yz; }   // at the target's top left
ivec2 regionSize() { return resolveBlock.spread.xy; }  // pixels that are drawn
ivec2 targetSize() { return resolveBlock.spread.zw; }  // texels that stand for them
float distanceFactor() { return resolveBlock.weightTerms.x; }    // on α, by the sample's distance from the center
int eighthsOfFrame() { return int(resolveBlock.weightTerms.y); } // of the reference frame that this one took
vec2 lastJitter() { return resolveBlock.weightTerms.zw; }          // of the frame before, render px

/// The pixel that this fragment stands for. A target with fewer texels than its region has pixels holds for each texel
/// exactly what the pixel in its middle is.
ivec2 pixelHere() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  if (kIsSparse) texel = (2 * texel + 1) * regionSize() / (2 * targetSize());
  return texel + firstPixel();
}

bool hasHistory() { return (historyFlags() & 1) != 0; }

/// Whether the history holds a layer that not all settings keep.
bool keeps(int layer) { return (historyFlags() & layer) != 0; }

/// View depth in m of a device depth; 0 stands for the sky.
float viewDepth(float depth) {
  precise float numerator = depth * resolveBlock.depthTerms.x - resolveBlock.depthTerms.y;
  precise float denominator = depth * resolveBlock.depthTerms.z - resolveBlock.depthTerms.w;
  precise float result = numerator / denominator;
  return mix(result, 0.0, depth == 0.0);
}

/// The render texel whose sample lies nearest to a pixel's center, and the way there from the center in render px:
/// d = k + ½ − j − r·xₒ (manual §22). At full size the pixel itself.
struct Place {
  ivec2 texel;
  vec2 offset;
  ivec2 still; // the render texel that holds the center without jitter
};

Place placeOf(ivec2 pixel) {
  if (!kUpsampled) return Place(pixel, vec2(0.0), pixel);
  precise vec2 center = (vec2(pixel) + 0.5) * resolveBlock.renderRatio;
  precise vec2 nearest = floor(center + resolveBlock.jitterPx);
  ivec2 texel = clampedToDrawn(ivec2(nearest));
  precise vec2 offset = ((vec2(texel) + 0.5) - center) - resolveBlock.jitterPx;
  return Place(texel, offset, clampedToDrawn(ivec2(floor(center))));
}

/// A motion of the inputs in px of the picture; the mark of no previous position stays.
vec2 pictureMotion(vec2 motion) {
  precise vec2 scaled = motion / resolveBlock.renderRatio;
  return kUpsampled && motion.x != kNoPreviousPosition ? scaled : motion;
}

/// This frame's sane colors around a render texel, 3×3 row-major: 4 is the texel itself.
struct Samples {
  vec3 color[9];
  vec2 mask; // of the pixel: reactive, responsive; read where a stage uses it
};

const bool kUsesMask = kNeighborhoodMaskRelax || kWeightMask != kWeightMask_off || kRectifyLocks || kRectifyInstability;

Samples readInputs(Place place) {
  ivec2 texel = place.texel;
  Samples samples;
  for (int k = 0; k < 9; ++k) {
    samples.color[k] = sanitized(texelAt(u_color, texel + ivec2(k % 3 - 1, k / 3 - 1)).rgb);
  }
  samples.mask = kUsesMask ? texelAt(u_mask, texel).rg : vec2(0.0);
  expose_color(texelFetch(u_color, texel, 0).rgb);
  expose_depth(texelFetch(u_depth, texel, 0).r);
  expose_depthView(viewDepth(texelFetch(u_depth, texel, 0).r));
  expose_motion(texelFetch(u_motion, texel, 0).rg);
  expose_normal(texelFetch(u_normal, texel, 0).xyz);
  expose_objectId(float(texelFetch(u_objectId, texel, 0).r));
  expose_reactive(texelAt(u_mask, texel).r);
  expose_responsive(texelAt(u_mask, texel).g);
  expose_overlay(texelAt(u_overlay, place.still).rgb);
  expose_overlayAlpha(texelAt(u_overlay, place.still).a);
  expose_fog(texelAt(u_fog, texel).rgb);
  expose_fogOpacity(texelAt(u_fog, texel).a);
  expose_forwardCount(texelAt(u_forwardCount, texel).r);
  expose_objectClass(texelFetch(u_normal, texel, 0).w);
  return samples;
}

/// The color kept within the nine.
vec3 boundedBySamples(vec3 color, Samples samples) {
  vec3 lowest = samples.color[0];
  vec3 highest = samples.color[0];
  for (int k = 1; k < 9; ++k) {
    lowest = minimum(lowest, samples.color[k]);
    highest = maximum(highest, samples.color[k]);
  }
  return clamped(color, lowest, highest);
}
