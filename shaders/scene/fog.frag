// Fog laid over the shaded color. In: color, fog as it was marched; with a history the mean of the frames before.
// Out: color, and the fog that it has got. kFogHistory: the constraint of that mean (manual 20.5).
#include "include/storage.glsl"
#include "shared/FogBlock.h"

layout(binding = 0) uniform sampler2D u_color;
layout(binding = 1) uniform sampler2D u_fog;
layout(binding = 2) uniform sampler2D u_before;

layout(location = 0) out vec4 o_color;
layout(location = 1) out vec4 o_fog;

/// Kept within the smallest and largest of this frame's 3×3.
vec4 clamped(vec4 before, ivec2 pixel) {
  ivec2 border = textureSize(u_fog, 0) - 1;
  vec4 lowest = texelFetch(u_fog, pixel, 0), highest = lowest;
  for (int k = 0; k < 9; ++k) {
    vec4 near = texelFetch(u_fog, clamp(pixel + ivec2(k % 3 - 1, k / 3 - 1), ivec2(0), border), 0);
    lowest = min(lowest, near);
    highest = max(highest, near);
  }
  return clamp(before, lowest, highest);
}

vec4 fogHere(ivec2 pixel) {
  vec4 now = texelFetch(u_fog, pixel, 0);
  if (kFogHistory == kFogHistory_none || fog.counts.y < 2) return now;
  vec4 before = texelFetch(u_before, pixel, 0);
  if (kFogHistory == kFogHistory_clamped) before = clamped(before, pixel);
  if (kFogHistory == kFogHistory_largest) before = max(before, now);
  float frames = float(fog.counts.y);
  precise vec4 mean = (now + (frames - 1.0) * before) / frames;
  return frame.storage.x > 0.5 ? vec4(roundedToHalf(mean.rgb), roundedToHalf(mean.aaa).x) : mean;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 over = fogHere(pixel);
  precise vec3 color = texelFetch(u_color, pixel, 0).rgb * (1.0 - over.a) + over.rgb;
  o_color = storedColor(color);
  o_fog = over;
}
