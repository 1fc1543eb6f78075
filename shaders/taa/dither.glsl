// Random numbers of a pixel in a frame, to round or to show colors with (manual 20.6, 20.8). In: the pixel. Out: 13
// bits each; white, so nothing of the jitter's period is in them.

#include "include/random.glsl"

uint randomSeed(ivec2 pixel) {
  return hashed(hashed(hashed(uint(pixel.x)) + uint(pixel.y)) + uint(frameNumber()));
}

/// For each channel of what is stored.
uvec3 randomBits(ivec2 pixel) {
  uint seed = randomSeed(pixel);
  return uvec3(hashed(seed), hashed(seed + 1u), hashed(seed + 2u)) >> 19u;
}

/// Triangular noise, −1 to 1, that has nothing to do with what was stored with.
float triangularNoise(ivec2 pixel) {
  uint seed = randomSeed(pixel);
  vec2 bits = vec2(uvec2(hashed(seed + 3u), hashed(seed + 4u)) >> 19u);
  precise float sum = ((bits.x + 0.5) + (bits.y + 0.5)) / 8192.0;
  precise float result = sum - 1.0;
  return result;
}
