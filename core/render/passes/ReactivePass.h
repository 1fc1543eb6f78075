// Marks what blending changed: the difference of the opaque picture and the whole one (manual 21.5, FSR2).
#pragma once

#include "core/gl/RenderPass.h"

#include <optional>

namespace taa {

class ReactivePass {
 public:
  ReactivePass();
  /// With its shader compiled again, where it was compiled.
  ReactivePass reloaded() const;

  /// Keeps a copy of the opaque picture.
  void keepOpaque(const gl::Texture& color);
  /// Into the first channel of `mask`, where it is larger. `part`: what is drawn, default all.
  void draw(const gl::Texture& color, const gl::Texture& mask, const std::optional<gl::Rect>& part = {});

 private:
  gl::Sampler nearest_;
  gl::Program program_; ///< compiled when first used
  gl::Texture opaque_;
};

} // namespace taa
