#include "core/render/passes/FogPass.h"

#include "core/render/passes/SceneRenderer.h"

#include <cassert>
#include <string>
#include <utility>

namespace taa {

namespace {

void fitTo(const gl::Texture& color, gl::Texture& texture, const char* label) {
  if (texture && texture.size() == color.size() && texture.format() == color.format()) return;
  texture = gl::Texture();
  texture = gl::Texture(color.size(), color.format(), label);
}

std::string fogHistoryPrelude(FogHistory history) {
  const auto constant = [](const char* name, FogHistory value) {
    return std::string("const int ") + name + " = " + std::to_string(static_cast<int>(value)) + ";\n";
  };
  return constant("kFogHistory", history) + constant("kFogHistory_none", FogHistory::None) +
         constant("kFogHistory_clamped", FogHistory::Clamped) +
         constant("kFogHistory_largest", FogHistory::LargestAsPrinted);
}

} // namespace

FogPass::Programs FogPass::compile(const Variant& variant) {
  const std::string prelude = noisePrelude(variant.noise) + fogHistoryPrelude(variant.history) +
                              "const bool kExact = " + (variant.isExact ? "true" : "false") + ";\n";
  const gl::ShaderSource vertices("include/fullscreen.vert");
  return {{vertices, gl::ShaderSource("scene/fog_march.frag", prelude), "FogPass march"},
          {vertices, gl::ShaderSource("scene/fog.frag", prelude), "FogPass"}};
}

FogPass::FogPass() : block_(sizeof(shared::FogBlock), nullptr, "fog"), nearest_(gl::SamplerState{}) {}

FogPass FogPass::reloaded() const {
  FogPass pass;
  for (const auto& [variant, programs] : programs_) pass.programs_.emplace(variant, compile(variant));
  return pass;
}

std::size_t FogPass::scratchBytes(const InputSettings& settings, std::size_t colorBytes) {
  return (settings.fogHistory == FogHistory::None ? 2 : 3) * colorBytes;
}

void FogPass::rest() {
  for (gl::Texture* texture : {&marched_, &before_, &other_}) *texture = gl::Texture();
}

void FogPass::fit(const FrameInputs& out, bool hasHistory) {
  fitTo(out.color, marched_, "fog of this frame");
  fitTo(out.color, other_, "color");
  if (hasHistory)
    fitTo(out.color, before_, "fog of frames before");
  else
    before_ = gl::Texture();
}

void FogPass::draw(const Scene& scene, const FrameRequest& request, const View& view, const gl::Buffer& frame,
                   FrameInputs& out) {
  const InputSettings& settings = request.inputs;
  assert(drawsFog(scene, settings));
  const bool isExact = settings.fogSteps == 0, hasHistory = settings.fogHistory != FogHistory::None;
  const Variant variant{isExact ? InputNoise::None : settings.fogNoise, isExact, settings.fogHistory};
  if (!programs_.contains(variant)) programs_.emplace(variant, compile(variant));
  const Programs& programs = programs_.at(variant);
  fit(out, hasHistory);
  fitTo(out.color, out.fog, "fog");
  const shared::FogBlock block = fogBlock(scene, request, view);
  block_.update(0, &block, sizeof(block));
  {
    const gl::Framebuffer target({{&marched_}, {hasHistory ? &before_ : nullptr}}, nullptr, "fog march");
    gl::RenderPass pass(target, {.scissor = view.part}, "FogPass march");
    pass.program(programs.march);
    pass.uniformBlock(2, frame);
    pass.uniformBlock(7, block_);
    pass.texture(0, out.depth, nearest_);
    pass.texture(NoiseSource::kUnit, source_.tile(), nearest_);
    pass.drawFullscreen();
  }
  const gl::Framebuffer target({{&other_}, {&out.fog}}, nullptr, "fog");
  gl::RenderPass pass(target, {.scissor = view.part}, "FogPass");
  pass.program(programs.apply);
  pass.uniformBlock(2, frame);
  pass.uniformBlock(7, block_);
  pass.texture(0, out.color, nearest_);
  pass.texture(1, marched_, nearest_);
  pass.texture(2, hasHistory ? before_ : marched_, nearest_);
  pass.drawFullscreen();
  std::swap(out.color, other_);
}

} // namespace taa
