// Draws the sky behind everything, with the motion of its directions.
#pragma once

#include "core/gl/RenderPass.h"

#include <optional>

namespace taa {

class SkyPass {
 public:
  SkyPass();
  /// Where `target` holds depth 0. `frame` holds the view's block.
  void draw(const gl::Buffer& frame, const gl::Framebuffer& target,
            const std::optional<gl::Rect>& part = {}) const;
  /// Compiles again; on Error the old program stays.
  void reloadShaders();

 private:
  gl::Program program_;
};

} // namespace taa
