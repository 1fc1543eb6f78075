// The pass after the resolve.
#include "core/taa/OutputPass.h"

#include <string>

namespace taa {

namespace {

// What the shader depends on, so that other choices share its programs.
Settings relevantSettings(const Settings& settings) {
  Settings relevant;
  relevant.dilate = settings.dilate;
  relevant.output = settings.output;
  relevant.inputs.renderScale = settings.inputs.renderScale;
  return relevant;
}

std::string prelude(const Settings&, const std::vector<IntermediateId>& watched) {
  return exposePrelude(watched, 0);
}

// Whether there is a layer to lay over the picture.
std::string overlayConstant(bool hasOverlay) {
  return std::string("const bool kHasOverlay = ") + (hasOverlay ? "true" : "false") + ";\n";
}

} // namespace

OutputPass::OutputPass() : programs("taa/output.frag", "output", prelude) {}

void OutputPass::fill(const FrameInputs& inputs, const gl::Texture& resolved, const Settings& settings,
                      const Exposure& exposure) {
  const std::vector<IntermediateId> rows = rowsOfOutput(exposure.watched());
  if (rows.empty()) return;
  std::vector<gl::Attachment> targets;
  for (const IntermediateId id : rows) targets.push_back({&exposure.texture(id), exposure.layer(id)});
  const gl::Program& program =
      programs.program(relevantSettings(settings), rows, overlayConstant(bool(inputs.overlay)));
  passInputs_.update(inputs, settings, 0, {exposure.region().x, exposure.region().y});
  const gl::Framebuffer target(targets, nullptr, "output");
  gl::RenderPass pass(target, {}, "OutputPass");
  pass.program(program);
  passInputs_.bind(pass, inputs);
  pass.texture(8, resolved, passInputs_.nearest());
  pass.drawFullscreen();
}

void OutputPass::prepare(const Settings& settings, const std::vector<IntermediateId>& watched) {
  const std::vector<IntermediateId> rows = rowsOfOutput(watched);
  if (rows.empty()) return;
  const bool hasOverlay = settings.inputs.blended == BlendedAs::After;
  programs.program(relevantSettings(settings), rows, overlayConstant(hasOverlay));
}

} // namespace taa
