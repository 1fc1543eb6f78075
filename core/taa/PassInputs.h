// What the passes of TAA are given alike: the block of the frame, the numbers of the settings, and its
// textures.
#pragma once

#include "core/gl/Buffer.h"
#include "core/gl/RenderPass.h"
#include "core/render/FrameInputs.h"
#include "core/settings/Settings.h"

#include <string>

namespace taa {

/// Which pixels of the picture the texels of a target stand for: a region, all of them or some.
struct TargetPixels {
  gl::Rect region;
  glm::ivec2 texels{1};
};

/// GLSL that says whether the target has fewer texels than its region has pixels.
std::string sparsePrelude(bool isSparse);

/// Keeps the uniform blocks and binds them with the inputs of a frame, as shaders/taa/inputs.glsl names them.
class PassInputs {
 public:
  PassInputs();

  /// Fills the blocks: before the pass begins. `historyState`: bits of what history there is (ResolveBlock).
  void update(const FrameInputs& inputs, const Settings& settings, int historyState,
              const TargetPixels& target);
  /// Blocks, and all textures but those of the history.
  void bind(gl::RenderPass& pass, const FrameInputs& inputs) const;
  /// Reads single texels: bind what else there is with it.
  const gl::Sampler& nearest() const { return nearest_; }

 private:
  gl::Sampler nearest_;
  gl::Texture nothing_, unknown_;
  gl::Buffer resolveBlock_, settingsBlock_;
};

} // namespace taa
