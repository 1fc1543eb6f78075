// The pass after the resolve.
#include "core/taa/OutputPass.h"

#include <string>
#include <vector>

namespace taa {

namespace {

const gl::Program& programFor(ProgramCache& programs, const Settings& settings, bool hasOverlay,
                              bool isSparse, const ExposedLayout& layout) {
  const std::string key =
      std::string(hasOverlay ? "overlay " : "") + (isSparse ? "sparse " : "") + slotsKey(layout.ofOutput());
  return programs.program(outputSettings(settings), key, [&] {
    return overlayPrelude(hasOverlay) + sparsePrelude(isSparse) + exposeAsTargets(layout.ofOutput(), 0);
  });
}

} // namespace

bool changesOutput(const Settings& settings) {
  const OutputSettings& output = settings.output;
  const bool isFiltered =
      output.sharpen != Sharpen::None || output.motionBlur == Switch::On || output.dither == Switch::On;
  return (isTaaOn(settings) && isFiltered) || settings.inputs.blended == BlendedAs::After;
}

Settings outputSettings(const Settings& settings) {
  Settings relevant;
  relevant.jitter.taa = settings.jitter.taa;
  relevant.dilate = settings.dilate;
  relevant.output = settings.output;
  relevant.inputs.renderScale = settings.inputs.renderScale;
  return relevant;
}

std::string overlayPrelude(bool hasOverlay) {
  return std::string("const bool kHasOverlay = ") + (hasOverlay ? "true" : "false") + ";\n";
}

OutputPass::OutputPass() : programs("taa/output.frag", "output") {}

void OutputPass::fill(const FrameInputs& inputs, const gl::Texture& resolved, const Settings& settings,
                      const ExposedRows& exposedRows) {
  const ExposedLayout& layout = exposedRows.layout();
  if (layout.ofOutput().empty()) return;
  std::vector<gl::Attachment> targets;
  for (const ExposedSlot& slot : layout.ofOutput())
    targets.push_back({&exposedRows.textureOf(slot), slot.layer});
  const gl::Program& program =
      programFor(programs, settings, bool(inputs.overlay), exposedRows.isSparse(), layout);
  passInputs_.update(inputs, settings, 0, {exposedRows.region(), exposedRows.texels()});
  const gl::Framebuffer target(targets, nullptr, "output");
  gl::RenderPass pass(target, {}, "OutputPass");
  pass.program(program);
  passInputs_.bind(pass, inputs);
  pass.texture(8, resolved, passInputs_.nearest());
  pass.drawFullscreen();
}

void OutputPass::prepare(const Settings& settings, const ExposedLayout& layout) {
  if (layout.ofOutput().empty()) return;
  const bool hasOverlay = settings.inputs.blended == BlendedAs::After;
  programFor(programs, settings, hasOverlay, false, layout);
}

} // namespace taa
