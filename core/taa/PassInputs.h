// What the passes of TAA are given alike: the block of the frame, the numbers of the settings, and its
// textures.
#pragma once

#include "core/gl/Buffer.h"
#include "core/gl/RenderPass.h"
#include "core/render/FrameInputs.h"
#include "core/settings/Settings.h"

namespace taa {

/// Keeps the uniform blocks and binds them with the inputs of a frame, as shaders/taa/inputs.glsl names them.
class PassInputs {
 public:
  PassInputs();

  /// Fills the blocks: before the pass begins. `historyState`: bits of what history there is (ResolveBlock).
  /// `corner`: the picture's pixel at the target's top left.
  void update(const FrameInputs& inputs, const Settings& settings, int historyState,
              const glm::ivec2& corner);
  /// Blocks, and all textures but those of the history.
  void bind(gl::RenderPass& pass, const FrameInputs& inputs) const;
  /// Reads single texels: bind what else there is with it.
  const gl::Sampler& nearest() const { return nearest_; }

 private:
  gl::Sampler nearest_;
  gl::Texture nothing_;
  gl::Buffer resolveBlock_, settingsBlock_;
};

} // namespace taa
