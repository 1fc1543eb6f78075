// Blocks and textures of a frame for the passes of TAA.
#include "core/taa/PassInputs.h"

#include "core/settings/Parameters.h"
#include "core/taa/TaaPass.h"
#include "shaders/shared/ResolveBlock.h"

#include <array>
#include <cstddef>
#include <iterator>
#include <vector>

namespace taa {

namespace {

// Units of shaders/taa/inputs.glsl for what a frame may be without.
constexpr unsigned kFogUnit = 13, kMaskUnit = 14, kOverlayUnit = 15, kForwardUnit = 16;

shared::ResolveBlock makeBlock(const FrameInputs& inputs, const Settings& settings, int historyState,
                               const TargetPixels& target) {
  const std::array<float, 9> w = currentFilterWeights(settings.current, inputs.info.jitterPx);
  shared::ResolveBlock block{};
  block.sizePx = glm::vec2(inputs.outputWidth(), inputs.outputHeight());
  block.renderSizePx = glm::vec2(inputs.width(), inputs.height());
  block.renderRatio = block.renderSizePx / block.sizePx;
  block.jitterPx = inputs.info.jitterPx;
  block.depthTerms = inputs.block.depthTerms;
  block.currentWeights0 = glm::vec4(w[0], w[1], w[2], 0.0f);
  block.currentWeights1 = glm::vec4(w[3], w[4], w[5], 0.0f);
  block.currentWeights2 = glm::vec4(w[6], w[7], w[8], 0.0f);
  const glm::vec2 distance =
      isUpsampled(settings) ? glm::vec2(0.0f) : inputs.info.jitterPx; // else it is in κ
  block.weightTerms.x = sampleDistanceFactor(settings.weight.sampleDistance, distance);
  block.weightTerms.y =
      static_cast<float>(frameEighths(inputs.info.stepSeconds, settings.weight.referenceRate));
  // Of the last frame, which fault.historyJitter alone reads.
  block.weightTerms.z = inputs.block.previousJitter.x;
  block.weightTerms.w = inputs.block.previousJitter.y;
  block.state = glm::ivec4(historyState, target.region.x, target.region.y, inputs.info.frame);
  block.spread = glm::ivec4(target.region.width, target.region.height, target.texels);
  return block;
}

// What is read where a frame has no fog, no mask and no overlay.
gl::Texture blackTexel() {
  gl::Texture texture({.width = 1, .height = 1}, gl::Format::RGBA8, "nothing");
  texture.clear(0.0f, 0.0f, 0.0f, 0.0f);
  return texture;
}

// Likewise where the last frame's pixels are not counted.
gl::Texture unknownTexel() {
  gl::Texture texture({.width = 1, .height = 1}, gl::Format::R32F, "unknown");
  texture.clear(kForwardUnknown, 0.0f, 0.0f, 0.0f);
  return texture;
}

} // namespace

std::string sparsePrelude(bool isSparse) {
  return std::string("const bool kIsSparse = ") + (isSparse ? "true" : "false") + ";\n";
}

PassInputs::PassInputs()
    : nearest_(gl::SamplerState{}), nothing_(blackTexel()), unknown_(unknownTexel()),
      resolveBlock_(sizeof(shared::ResolveBlock), nullptr, "ResolveBlock"),
      settingsBlock_(taa::settingsBlock(Settings{}).size(), nullptr, "SettingsBlock") {}

void PassInputs::update(const FrameInputs& inputs, const Settings& settings, int historyState,
                        const TargetPixels& target) {
  const shared::ResolveBlock block = makeBlock(inputs, settings, historyState, target);
  const std::vector<std::byte> numbers = taa::settingsBlock(settings);
  resolveBlock_.update(0, &block, sizeof(block));
  settingsBlock_.update(0, numbers.data(), numbers.size());
}

void PassInputs::bind(gl::RenderPass& pass, const FrameInputs& inputs) const {
  pass.uniformBlock(0, resolveBlock_);
  pass.uniformBlock(1, settingsBlock_);
  const gl::Texture* textures[] = {&inputs.color,  &inputs.depth,    &inputs.motion,
                                   &inputs.normal, &inputs.objectId, &inputs.previousDepth};
  for (unsigned unit = 0; unit < std::size(textures); ++unit) pass.texture(unit, *textures[unit], nearest_);
  pass.texture(kFogUnit, inputs.fog ? inputs.fog : nothing_, nearest_);
  pass.texture(kMaskUnit, inputs.mask ? inputs.mask : nothing_, nearest_);
  pass.texture(kForwardUnit, inputs.forwardCount ? inputs.forwardCount : unknown_, nearest_);
  pass.texture(kOverlayUnit, inputs.overlay ? inputs.overlay : nothing_, nearest_);
}

} // namespace taa
