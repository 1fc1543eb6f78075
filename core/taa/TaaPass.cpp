#include "core/taa/TaaPass.h"

#include "core/taa/OutputPass.h"
#include "core/taa/PassInputs.h"
#include "core/taa/ProgramCache.h"

#include <cassert>

namespace taa {

namespace {

using Watched = std::vector<IntermediateId>;

// What the resolve's shader depends on: what is shown of its picture is another program's business.
Settings relevantSettings(const Settings& settings) {
  Settings relevant = settings;
  relevant.output = {};
  return relevant;
}

gl::TextureSize outputSize(const FrameInputs& inputs) {
  return {inputs.outputWidth(), inputs.outputHeight()};
}

// Where the resolve draws: into the history, if there is one to write, and into the exposure's targets.
std::vector<gl::Attachment> attachments(const History* out, const Exposure* exposure) {
  std::vector<gl::Attachment> targets(kHistoryTargets);
  if (out) targets = {{&out->color}, {&out->surface}};
  const std::vector<IntermediateId> rows = exposure ? rowsOfResolve(exposure->watched()) : Watched{};
  if (exposesAsTargets(rows))
    for (const IntermediateId id : rows) targets.push_back({&exposure->texture(id), exposure->layer(id)});
  return targets;
}

} // namespace

struct TaaPass::Parts {
  ProgramCache programs{"taa/resolve.frag", "resolve", kHistoryTargets};
  PassInputs passInputs;
  OutputPass output;

  void run(const gl::Framebuffer& target, const FrameInputs& inputs, const History* previous,
           const Settings& settings, const Exposure* exposure);
};

void TaaPass::Parts::run(const gl::Framebuffer& target, const FrameInputs& inputs, const History* previous,
                         const Settings& settings, const Exposure* exposure) {
  const bool hasHistory = previous && !inputs.info.startsHistory;
  assert(!hasHistory || previous->color.size() == outputSize(inputs));
  assert(isUpsampled(settings) || outputSize(inputs) == inputs.color.size());
  const Watched rows = exposure ? rowsOfResolve(exposure->watched()) : Watched{};
  const gl::Program& resolve = programs.program(relevantSettings(settings), rows);
  const gl::Rect region = exposure ? exposure->region() : gl::Rect{};
  passInputs.update(inputs, settings, hasHistory, {region.x, region.y});

  gl::RenderPass pass(target, {}, "TaaPass");
  pass.program(resolve);
  passInputs.bind(pass, inputs);
  // Without history the shader uses nothing of what it reads there, but the reads want a texture.
  pass.texture(6, hasHistory ? previous->color : inputs.color, passInputs.nearest());
  pass.texture(7, hasHistory ? previous->surface : inputs.motion, passInputs.nearest());
  const bool stores = !exposesAsTargets(rows);
  if (stores) {
    const gl::Texture* images[] = {&exposure->one_, &exposure->two_, &exposure->four_};
    for (unsigned unit = 0; unit < std::size(images); ++unit)
      if (*images[unit]) pass.image(unit, *images[unit]);
  }
  pass.drawFullscreen();
  if (stores) gl::imageBarrier();
}

TaaPass::TaaPass() : parts_(std::make_unique<Parts>()) {}
TaaPass::~TaaPass() = default;
TaaPass::TaaPass(TaaPass&&) noexcept = default;
TaaPass& TaaPass::operator=(TaaPass&&) noexcept = default;

void TaaPass::resolve(const FrameInputs& inputs, const History* previous, const Settings& settings,
                      History& out, Exposure* exposure) {
  assert(&out != previous);
  const gl::TextureSize size = outputSize(inputs);
  assert(!exposure || exposure->region() == (gl::Rect{0, 0, size.width, size.height}));
  fitHistory(out, size.width, size.height, settings.history.precision);
  const gl::Framebuffer target(attachments(&out, exposure), nullptr, "resolved");
  parts_->run(target, inputs, previous, settings, exposure);
  if (exposure) parts_->output.fill(inputs, out.color, settings, *exposure);
}

void TaaPass::expose(const FrameInputs& inputs, const History* previous, const History& resolved,
                     const Settings& settings, Exposure& exposure) {
  const Watched rows = rowsOfResolve(exposure.watched());
  const gl::Rect& region = exposure.region();
  if (!rows.empty()) {
    const gl::Framebuffer target =
        exposesAsTargets(rows) ? gl::Framebuffer(attachments(nullptr, &exposure), nullptr, "exposed region")
                               : gl::Framebuffer(region.width, region.height, "exposed region");
    parts_->run(target, inputs, previous, settings, &exposure);
  }
  parts_->output.fill(inputs, resolved.color, settings, exposure);
}

void TaaPass::prepare(const Settings& settings, const std::vector<IntermediateId>& watched) {
  const Watched rows = inTableOrder(watched);
  parts_->programs.program(relevantSettings(settings), rowsOfResolve(rows));
  parts_->output.prepare(settings, rows);
}

void TaaPass::reloadShaders() {
  ProgramCache programs = parts_->programs.compiledAnew();
  ProgramCache output = parts_->output.programs.compiledAnew();
  parts_->programs = std::move(programs); // not reached when one of them does not compile
  parts_->output.programs = std::move(output);
}

} // namespace taa
