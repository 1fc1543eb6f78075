// Writes motion and previous depth anew from the depth buffer, as if nothing but the camera moved (manual
// §3.1).
#pragma once

#include "core/gl/RenderPass.h"
#include "core/render/FrameInputs.h"
#include "core/settings/Settings.h"

#include <map>
#include <optional>

namespace taa {

/// Whether motion is that of the camera alone, which this pass draws; else objects write theirs.
bool isFromDepth(MotionSource source);

class CameraMotionPass {
 public:
  CameraMotionPass();
  /// From `out.depth` into `out.motion` and `out.previousDepth`. `frame` holds the view's block; `part`: what
  /// is drawn, default all. Expects a source that isFromDepth(); throws Error when its program does not
  /// compile.
  void draw(MotionSource source, const gl::Buffer& frame, const FrameInputs& out,
            const std::optional<gl::Rect>& part = {});
  /// One with the programs of this one, compiled again.
  CameraMotionPass reloaded() const;

 private:
  std::map<MotionSource, gl::Program> programs_; ///< made when they are first asked for
  gl::Sampler nearest_;
};

} // namespace taa
