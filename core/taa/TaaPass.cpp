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

std::string prelude(const Settings& settings, const Watched& watched) {
  return historyPrelude(settings) + exposePrelude(watched, historyTargets(settings));
}

// Bit 0: there is history; the others: the layers of it that these settings need and it holds.
int historyState(const History* previous, const Settings& settings) {
  if (!previous) return 0;
  int state = 1, bit = 2;
  for (const HistoryLayer& layer : historyLayers()) {
    if (layer.isNeeded(settings) && previous->*layer.texture) state |= bit;
    bit *= 2;
  }
  return state;
}

// Where the resolve draws: into the history, if there is one to write, and into the exposure's targets.
std::vector<gl::Attachment> attachments(const History* out, const Exposure* exposure,
                                        const Settings& settings) {
  std::vector<gl::Attachment> targets(historyTargets(settings));
  if (out) {
    targets = {{&out->color}, {&out->surface}};
    for (const HistoryLayer& layer : historyLayers())
      if (layer.isNeeded(settings)) targets.push_back({&(out->*layer.texture)});
  }
  const std::vector<IntermediateId> rows = exposure ? rowsOfResolve(exposure->watched()) : Watched{};
  if (exposesAsTargets(rows, targets.size()))
    for (const IntermediateId id : rows) targets.push_back({&exposure->texture(id), exposure->layer(id)});
  return targets;
}

} // namespace

struct TaaPass::Parts {
  ProgramCache programs{"taa/resolve.frag", "resolve", prelude};
  PassInputs passInputs;
  OutputPass output;

  void bindHistory(gl::RenderPass& pass, const FrameInputs& inputs, const History* previous,
                   const Settings& settings) const;
  void run(const gl::Framebuffer& target, const FrameInputs& inputs, const History* previous,
           const Settings& settings, const Exposure* exposure);
};

void TaaPass::Parts::bindHistory(gl::RenderPass& pass, const FrameInputs& inputs, const History* previous,
                                 const Settings& settings) const {
  // Without history the shader uses nothing of what it reads there, but the reads want a texture of this
  // size.
  pass.texture(6, previous ? previous->color : inputs.color, passInputs.nearest());
  pass.texture(7, previous ? previous->surface : inputs.motion, passInputs.nearest());
  unsigned unit = kFirstLayerUnit;
  for (const HistoryLayer& layer : historyLayers()) {
    const bool isHeld = previous && previous->*layer.texture;
    if (layer.isNeeded(settings))
      pass.texture(unit, isHeld ? previous->*layer.texture : inputs.motion, passInputs.nearest());
    ++unit;
  }
}

void TaaPass::Parts::run(const gl::Framebuffer& target, const FrameInputs& inputs, const History* previous,
                         const Settings& settings, const Exposure* exposure) {
  if (inputs.info.startsHistory) previous = nullptr;
  assert(!previous || previous->color.size() == outputSize(inputs));
  assert(isUpsampled(settings) || outputSize(inputs) == inputs.color.size());
  const Watched rows = exposure ? rowsOfResolve(exposure->watched()) : Watched{};
  const gl::Program& resolve = programs.program(relevantSettings(settings), rows);
  const gl::Rect region = exposure ? exposure->region() : gl::Rect{};
  passInputs.update(inputs, settings, historyState(previous, settings), {region.x, region.y});

  gl::RenderPass pass(target, {}, "TaaPass");
  pass.program(resolve);
  passInputs.bind(pass, inputs);
  bindHistory(pass, inputs, previous, settings);
  const bool stores = !exposesAsTargets(rows, historyTargets(settings));
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
  fitHistory(out, size.width, size.height, settings);
  const gl::Framebuffer target(attachments(&out, exposure, settings), nullptr, "resolved");
  parts_->run(target, inputs, previous, settings, exposure);
  if (exposure) parts_->output.fill(inputs, out.color, settings, *exposure);
}

void TaaPass::expose(const FrameInputs& inputs, const History* previous, const History& resolved,
                     const Settings& settings, Exposure& exposure) {
  const Watched rows = rowsOfResolve(exposure.watched());
  const gl::Rect& region = exposure.region();
  if (!rows.empty()) {
    const gl::Framebuffer target =
        exposesAsTargets(rows, historyTargets(settings))
            ? gl::Framebuffer(attachments(nullptr, &exposure, settings), nullptr, "exposed region")
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
