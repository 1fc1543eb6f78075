// What the resolve writes: the history textures, and the weights that depend on a frame's jitter.
#include "core/taa/TaaPass.h"

#include <cmath>

namespace taa {

void fitHistory(History& history, int width, int height, Precision precision) {
  const gl::Format format = precision == Precision::Half ? gl::Format::RGBA16F : gl::Format::RGBA32F;
  const gl::TextureSize size{width, height};
  if (history.color && history.color.size() == size && history.color.format() == format) return;
  // Both are cleared, because what memory held before must never show.
  gl::Texture color(size, format, "history color");
  gl::Texture surface(size, gl::Format::RG32F, "history surface");
  color.clear(0.0f, 0.0f, 0.0f, 0.0f);
  surface.clear(0.0f, 0.0f, 0.0f, 0.0f);
  history.color = std::move(color);
  history.surface = std::move(surface);
}

std::array<float, 9> currentFilterWeights(const CurrentSettings& settings, glm::vec2 jitterPx) {
  std::array<float, 9> weights{};
  if (settings.filter == CurrentFilter::Center) {
    weights[4] = 1.0f;
    return weights;
  }
  // The pixel's own scene sample lies at −jitter from its center, so a neighbor's lies at offset − jitter.
  for (int k = 0; k < 9; ++k) {
    const int column = k % 3 - 1, row = k / 3 - 1;
    const double dx = column - static_cast<double>(jitterPx.x);
    const double dy = row - static_cast<double>(jitterPx.y);
    const double twoVariances = 2.0 * static_cast<double>(settings.variance);
    weights[k] = static_cast<float>(std::exp(-(dx * dx + dy * dy) / twoVariances));
  }
  return weights;
}

} // namespace taa
