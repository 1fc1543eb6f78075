#include "core/render/passes/NoisePass.h"

#include "shaders/shared/NoiseBlock.h"

#include <cassert>
#include <string>
#include <utility>

namespace taa {

bool NoisePass::isNeeded(const InputSettings& settings) {
  return settings.noise != InputNoise::None || settings.range == DynamicRange::Ldr;
}

gl::Program NoisePass::compile(const Variant& variant) {
  const auto flag = [](const char* name, bool value) {
    return std::string("const bool ") + name + " = " + (value ? "true" : "false") + ";\n";
  };
  const std::string prelude = noisePrelude(variant.noise) + flag("kTriangular", variant.isTriangular) +
                              flag("kClipped", variant.isClipped);
  return {gl::ShaderSource("include/fullscreen.vert"), gl::ShaderSource("scene/noise.frag", prelude),
          "NoisePass"};
}

NoisePass::NoisePass() : block_(sizeof(shared::NoiseBlock), nullptr, "noise"), nearest_(gl::SamplerState{}) {}

NoisePass NoisePass::reloaded() const {
  NoisePass pass;
  for (const auto& [variant, program] : programs_) pass.programs_.emplace(variant, compile(variant));
  return pass;
}

void NoisePass::draw(const InputSettings& settings, const gl::Buffer& frame, FrameInputs& out,
                     const std::optional<gl::Rect>& part) {
  assert(isNeeded(settings));
  const Variant variant{settings.noise, settings.noiseTriangular == Switch::On,
                        settings.range == DynamicRange::Ldr};
  if (!programs_.contains(variant)) programs_.emplace(variant, compile(variant));
  if (!other_ || other_.size() != out.color.size() || other_.format() != out.color.format())
    other_ = gl::Texture(out.color.size(), out.color.format(), "color");
  const shared::NoiseBlock block{
      {settings.noiseAmount / 255.0f, static_cast<float>(out.info.frame % 256), 0.0f, 0.0f}};
  block_.update(0, &block, sizeof(block));

  const gl::Framebuffer target({{&other_}}, nullptr, "noise");
  gl::RenderPass pass(target, {.scissor = part}, "NoisePass");
  pass.program(programs_.at(variant));
  pass.uniformBlock(2, frame);
  pass.uniformBlock(6, block_);
  pass.texture(0, out.color, nearest_);
  pass.texture(NoiseSource::kUnit, source_.tile(), nearest_);
  pass.drawFullscreen();
  std::swap(out.color, other_);
}

} // namespace taa
