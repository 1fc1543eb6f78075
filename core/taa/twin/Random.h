// Random numbers of a pixel in a frame, white over pixels, frames and channels (manual 20.6, 20.8).
#pragma once

#include <glm/vec2.hpp>

#include <cstdint>

namespace taa::twin {

/// 0 to 8191. Channels 0 to 2 round what is stored, 3 and 4 are the screen's.
std::uint32_t randomBits(const glm::ivec2& pixel, int frame, std::uint32_t channel);
/// The sum of two such numbers, −1 to 1, triangular (manual 20.3).
float triangularNoise(const glm::ivec2& pixel, int frame);

} // namespace taa::twin
