// Stage 1, dilate motion: the nearest neighbor's motion, so that silhouettes move with what is in front.
#include "core/taa/reference/Color.h"
#include "core/taa/reference/Stages.h"

namespace taa::reference {

float viewDepth(float depth, const glm::vec4& depthTerms) {
  const auto& [p33, p32, p23, p22] = std::array{depthTerms.x, depthTerms.y, depthTerms.z, depthTerms.w};
  return depth == 0.0f ? 0.0f : (depth * p33 - p32) / (depth * p23 - p22);
}

Dilated dilateMotion(const Inputs& inputs, const DilateSettings& settings, const glm::ivec2& pixel) {
  Dilated result;
  result.depth = inputs.depth.texel(pixel.x, pixel.y).x;
  if (settings.method == DilateMethod::Closest3x3) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const glm::ivec2 neighbor = clampedToPicture(pixel + glm::ivec2(dx, dy), inputs);
        const float depth = inputs.depth.texel(neighbor.x, neighbor.y).x;
        if (depth > result.depth) { // reversed: larger is nearer; a tie keeps what came first
          result.depth = depth;
          result.offset = neighbor - pixel;
        }
      }
    }
  }
  const glm::ivec2 chosen = pixel + result.offset;
  result.motion = glm::vec2(inputs.motion.texel(chosen.x, chosen.y));
  return result;
}

} // namespace taa::reference
