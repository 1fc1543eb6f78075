// Writes motion and previous depth anew from the depth buffer, as if nothing but the camera moved (catalogue
// §3.1).
#pragma once

#include "core/gl/RenderPass.h"
#include "core/render/FrameInputs.h"

namespace taa {

class CameraMotionPass {
 public:
  CameraMotionPass();
  /// From `out.depth` into `out.motion` and `out.previousDepth`. `frame` holds the view's block.
  void draw(const gl::Buffer& frame, const FrameInputs& out) const;
  /// Compiles again; on Error the old program stays.
  void reloadShaders();

 private:
  gl::Program program_;
  gl::Sampler nearest_;
};

} // namespace taa
