// Values as their textures keep them. Some drivers store half floats by truncation (design §8), which would
// darken every average, so what is kept in 16 bits is rounded to nearest here.
#include "shared/FrameBlock.h"

const float kLargestHalf = 65504.0;

vec2 roundedToHalf(vec2 value) { return unpackHalf2x16(packHalf2x16(value)); }

/// Scene-linear color, made finite and not negative. NaN compares false and becomes 0.
vec4 storedColor(vec3 color) {
  color = mix(vec3(0.0), min(color, vec3(kLargestHalf)), greaterThan(color, vec3(0.0)));
  if (frame.storage.x > 0.5) color = vec3(roundedToHalf(color.rg), roundedToHalf(vec2(color.b, 0.0)).x);
  return vec4(color, 1.0);
}

vec2 storedMotion(vec2 motionPx) { return frame.storage.x > 0.5 ? roundedToHalf(motionPx) : motionPx; }
