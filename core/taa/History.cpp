// What the resolve writes: the history textures.
#include "core/taa/TaaPass.h"

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

} // namespace taa
