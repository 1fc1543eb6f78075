// Stage 4, filter current: the color at the pixel's center from the displaced samples around it.
#include "core/taa/reference/Color.h"
#include "core/taa/reference/Stages.h"

#include <cmath>

namespace taa::reference {

std::array<float, 9> gaussianWeights(float variance, const glm::vec2& jitterPx) {
  std::array<float, 9> weights{};
  std::size_t k = 0;
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      // Pixel o of this frame holds what belongs to o − j of the picture at rest.
      const double dx = x - static_cast<double>(jitterPx.x);
      const double dy = y - static_cast<double>(jitterPx.y);
      weights[k++] = static_cast<float>(std::exp(-(dx * dx + dy * dy) / (2.0 * variance)));
    }
  }
  return weights;
}

glm::vec3 filterCurrent(const Inputs& inputs, const CurrentSettings& settings, const glm::ivec2& pixel) {
  const glm::vec3 center = currentColor(inputs, pixel);
  if (settings.filter == CurrentFilter::Center) return center;
  const std::array<float, 9> weights = gaussianWeights(settings.variance, inputs.jitterPx);
  constexpr int kCenter = 4;
  float sum = 0.0f;
  glm::vec3 difference(0.0f);
  for (int k = 0; k < 9; ++k) {
    const float weight = weights[static_cast<std::size_t>(k)];
    sum = sum + weight;
    if (k == kCenter) continue;
    const glm::ivec2 offset(k % 3 - 1, k / 3 - 1);
    difference = difference + weight * (currentColor(inputs, pixel + offset) - center);
  }
  const glm::vec3 filtered = center + difference / sum; // differences, so that a constant stays itself
  glm::vec3 result;
  for (int i = 0; i < 3; ++i) result[i] = filtered[i] >= 0.0f ? filtered[i] : 0.0f;
  return result;
}

} // namespace taa::reference
