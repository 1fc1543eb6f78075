#include "core/render/passes/ReactivePass.h"

namespace taa {

namespace {

gl::Program compileReactive() {
  return {gl::ShaderSource("include/fullscreen.vert"), gl::ShaderSource("scene/reactive.frag"),
          "ReactivePass"};
}

} // namespace

ReactivePass::ReactivePass() : nearest_(gl::SamplerState{}) {}

ReactivePass ReactivePass::reloaded() const {
  ReactivePass pass;
  if (program_.id() != 0) pass.program_ = compileReactive();
  return pass;
}

void ReactivePass::keepOpaque(const gl::Texture& color) {
  if (!opaque_ || opaque_.size() != color.size() || opaque_.format() != color.format()) {
    opaque_ = gl::Texture();
    opaque_ = gl::Texture(color.size(), color.format(), "opaque color");
  }
  opaque_.copyFrom(color);
}

void ReactivePass::draw(const gl::Texture& color, const gl::Texture& mask,
                        const std::optional<gl::Rect>& part) {
  if (program_.id() == 0) program_ = compileReactive();
  const gl::Framebuffer target({{&mask}}, nullptr, "reactive");
  gl::RenderPass pass(target, {.scissor = part}, "ReactivePass");
  pass.program(program_);
  pass.texture(0, opaque_, nearest_);
  pass.texture(1, color, nearest_);
  pass.blending(0, gl::Blending::Largest);
  pass.drawFullscreen();
}

} // namespace taa
