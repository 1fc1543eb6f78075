// The last that happens to a shaded color before the resolve. In: scene-linear color, with what is blended over it.
// Out: the same, not negative; kClipped: no channel above 1 (catalogue 1.2); then with a noise that is one number for
// the three channels (20.1 to 20.4). kNoise, kTriangular: its form.
#include "include/storage.glsl"
#include "shared/NoiseBlock.h"

layout(binding = 0) uniform sampler2D u_color;
layout(binding = 1) uniform sampler2D u_tile; // 32×32 of blue noise

layout(location = 0) out vec4 o_color;

float fraction(float x) {
  precise float result = x - floor(x);
  return result;
}

/// Jimenez' interleaved gradient noise at p (px), moved along each frame; 64 frames, so that floats stay fine (20.1).
float gradientNoise(vec2 p, float number) {
  precise vec2 q = p + 5.588238 * number;
  precise float inner = 0.06711056 * q.x + 0.00583715 * q.y;
  precise float result = 52.9829189 * fraction(inner);
  return fraction(result);
}

/// A tile of ranks, moved on by an irrational step each frame (20.2).
float tileNoise(ivec2 p, float step, float number) {
  precise float result = texelFetch(u_tile, p & 31, 0).r + step * number;
  return fraction(result);
}

/// Two noises, each uniform from 0 to 1, that have nothing to do with each other.
vec2 noisePair(ivec2 pixel) {
  float number = noise.terms.y;
  if (kNoise == kBlueNoise) // 1/golden ratio, 1/plastic number
    return vec2(tileNoise(pixel, 0.61803398875, number), tileNoise(pixel.yx + ivec2(17, 5), 0.75487766625, number));
  float phase = mod(number, 64.0);
  return vec2(gradientNoise(vec2(pixel), phase), gradientNoise(vec2(pixel.yx) + 71.0, 63.0 - phase));
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  precise vec3 color = texelFetch(u_color, pixel, 0).rgb;
  if (kClipped) color = mix(color, vec3(1.0), greaterThan(color, vec3(1.0))); // NaN stays for storedColor()
  if (kNoise != kNoNoise) {
    vec2 u = noisePair(pixel);
    precise float added = noise.terms.x * (kTriangular ? u.x + u.y - 1.0 : u.x - 0.5);
    color += added;
  }
  o_color = storedColor(color);
}
