// Noise of a pixel in a frame (manual §20). In: kNoise, one of kGradientNoise, kBlueNoise, kWhiteNoise; the frame's
// number, less than 256. Out: numbers from 0 to 1.
#include "include/random.glsl"

layout(binding = 6) uniform sampler2D u_tile; // 32×32 of blue noise

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

/// 13 bits of a hash each, as randomBits() has them for what is stored.
vec2 whiteNoise(ivec2 pixel, float number) {
  uint seed = hashed(hashed(hashed(uint(pixel.x)) + uint(pixel.y)) + uint(number));
  vec2 bits = vec2(uvec2(hashed(seed + 5u), hashed(seed + 6u)) >> 19u);
  return (bits + 0.5) * (1.0 / 8192.0);
}

/// Two noises, each uniform, that have nothing to do with each other.
vec2 noisePair(ivec2 pixel, float number) {
  if (kNoise == kWhiteNoise) return whiteNoise(pixel, number);
  if (kNoise == kBlueNoise) // 1/golden ratio, 1/plastic number
    return vec2(tileNoise(pixel, 0.61803398875, number), tileNoise(pixel.yx + ivec2(17, 5), 0.75487766625, number));
  float phase = mod(number, 64.0);
  return vec2(gradientNoise(vec2(pixel), phase), gradientNoise(vec2(pixel.yx) + 71.0, 63.0 - phase));
}
