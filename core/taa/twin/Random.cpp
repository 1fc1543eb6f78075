#include "core/taa/twin/Random.h"

namespace taa::twin {
namespace {

/// PCG's permutation of 32 bits.
std::uint32_t hashed(std::uint32_t x) {
  const std::uint32_t state = x * 747796405u + 2891336453u;
  const std::uint32_t word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

std::uint32_t randomSeed(const glm::ivec2& pixel, int frame) {
  std::uint32_t seed = hashed(static_cast<std::uint32_t>(pixel.x));
  seed = hashed(seed + static_cast<std::uint32_t>(pixel.y));
  return hashed(seed + static_cast<std::uint32_t>(frame));
}

} // namespace

std::uint32_t randomBits(const glm::ivec2& pixel, int frame, std::uint32_t channel) {
  return hashed(randomSeed(pixel, frame) + channel) >> 19u;
}

float triangularNoise(const glm::ivec2& pixel, int frame) {
  const auto first = static_cast<float>(randomBits(pixel, frame, 3));
  const auto second = static_cast<float>(randomBits(pixel, frame, 4));
  return ((first + 0.5f) + (second + 0.5f)) / 8192.0f - 1.0f;
}

} // namespace taa::twin
