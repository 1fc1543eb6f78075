#include "core/render/passes/SkyPass.h"

namespace taa {

SkyPass::SkyPass() {
  reloadShaders();
}

void SkyPass::reloadShaders() {
  program_ =
      gl::Program(gl::ShaderSource("include/fullscreen.vert"), gl::ShaderSource("scene/sky.frag"), "SkyPass");
}

void SkyPass::draw(const gl::Buffer& frame, const gl::Framebuffer& target,
                   const std::optional<gl::Rect>& part) const {
  gl::RenderPass pass(target, {.depthTest = true, .depthWrite = false, .scissor = part}, "SkyPass");
  pass.program(program_);
  pass.uniformBlock(2, frame);
  pass.drawFullscreen();
}

} // namespace taa
