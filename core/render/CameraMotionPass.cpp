#include "core/render/CameraMotionPass.h"

namespace taa {

CameraMotionPass::CameraMotionPass() : nearest_(gl::SamplerState{}) {
  reloadShaders();
}

void CameraMotionPass::reloadShaders() {
  program_ = gl::Program(gl::ShaderSource("include/fullscreen.vert"),
                         gl::ShaderSource("scene/camera_motion.frag"), "CameraMotionPass");
}

void CameraMotionPass::draw(const gl::Buffer& frame, const FrameInputs& out) const {
  const gl::Framebuffer target({{&out.motion}, {&out.previousDepth}}, nullptr, "camera motion");
  gl::RenderPass pass(target, {}, "CameraMotionPass");
  pass.program(program_);
  pass.uniformBlock(2, frame);
  pass.texture(0, out.depth, nearest_);
  pass.drawFullscreen();
}

} // namespace taa
