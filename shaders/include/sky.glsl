// A simple sky: a vertical gradient with a sun disk, and what of it reaches surfaces. Directions are
// normalized, world space, y up; radiance in scene-linear units.
#include "shared/FrameBlock.h"

/// The gradient without the sun; `blur` 0…1 softens the horizon, for rough reflections. Ground fades into haze
/// towards the horizon, so that things which float in nothing stand before something calm.
vec3 skyGradient(float height, float blur) {
  float rest = 1.0 - min(abs(height), 1.0);
  float rest2 = rest * rest;
  float haze = (0.8 - 0.8 * blur) * (rest2 * rest2) * (rest2 * rest2) * (rest2 * rest2);
  vec3 sky = mix(frame.skyZenith.rgb, frame.skyHorizon.rgb, rest2 * rest);
  vec3 ground = mix(frame.skyGround.rgb, frame.skyHorizon.rgb, haze);
  float width = 0.004 + 0.996 * blur;
  return mix(ground, sky, smoothstep(-width, width, height));
}

/// Irradiance / π on a surface that faces `normal`: a hemisphere of sky above one of ground.
vec3 skyAmbient(vec3 normal) {
  vec3 above = 0.5 * (frame.skyZenith.rgb + frame.skyHorizon.rgb);
  return mix(frame.skyGround.rgb, above, 0.5 + 0.5 * normal.y);
}

/// What is seen in `direction`. The disk has three times the sun's real diameter and a soft rim.
vec3 skyRadiance(vec3 direction) {
  vec3 radiance = skyGradient(direction.y, 0.0);
  float cosine = dot(direction, frame.sunDirection.xyz);
  float disk = frame.sunDirection.w * smoothstep(0.99985, 0.99993, cosine);
  float glow = max(cosine, 0.0);
  for (int square = 0; square < 6; ++square) glow *= glow; // to the 64th
  glow *= frame.sunDirection.w;
  return radiance + frame.sunColor.rgb * (40.0 * disk + 0.12 * glow);
}
