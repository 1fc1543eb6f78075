// Values as their textures keep them. Some drivers store half floats by truncation (manual, architecture), which would
// darken every average, so what is kept in 16 bits is rounded to nearest here.
#include "shared/FrameBlock.h"

const float kLargestHalf = 65504.0;

/// Nearest (ties to even) value with the 11 significant bits of a half float. On the bits, because
/// unpackHalf2x16(packHalf2x16()) costs llvmpipe ten times as much. Below 2⁻¹⁴ the store itself still cuts, by
/// less than 2⁻²⁴.
vec3 roundedToHalf(vec3 value) {
  uvec3 bits = floatBitsToUint(value);
  return uintBitsToFloat((bits + 0xFFFu + ((bits >> 13u) & 1u)) & 0xFFFFE000u);
}

/// Scene-linear color, made finite and not negative. NaN compares false and becomes 0.
vec4 storedColor(vec3 color) {
  color = mix(vec3(0.0), min(color, vec3(kLargestHalf)), greaterThan(color, vec3(0.0)));
  if (frame.storage.x > 0.5) color = roundedToHalf(color);
  return vec4(color, 1.0);
}

vec2 storedMotion(vec2 motionPx) { return frame.storage.x > 0.5 ? roundedToHalf(vec3(motionPx, 0.0)).xy : motionPx; }
