#include "core/taa/TaaPass.h"

#include "core/taa/OutputPass.h"
#include "core/taa/PassInputs.h"
#include "core/taa/ProgramCache.h"

#include <algorithm>
#include <cassert>
#include <span>

namespace taa {

namespace {

// What the resolve's shader depends on: what is shown of its picture is another program's business.
Settings relevantSettings(const Settings& settings) {
  Settings relevant = settings;
  relevant.output = {};
  return relevant;
}

gl::TextureSize outputSize(const FrameInputs& inputs) {
  return {inputs.outputWidth(), inputs.outputHeight()};
}

// So small a region is exposed in one run whatever is watched: one program to compile, and stores cost
// little.
constexpr int kSmallRegion = 64 * 64;

/// One run of the resolve: whether it writes the history, and which slots how.
struct Run {
  bool keepsHistory = false, stores = false;
  std::span<const ExposedSlot> slots;

  std::string prelude(const Settings& settings) const {
    return historyPrelude(settings, keepsHistory) +
           (stores ? exposeAsStores(slots) : exposeAsTargets(slots, taken(settings)));
  }
  std::string key() const {
    return std::string(keepsHistory ? "history " : "") + (stores ? "stores " : "") + slotsKey(slots);
  }
  std::size_t taken(const Settings& settings) const { return keepsHistory ? historyTargets(settings) : 0; }
};

// Those that write the history, if it is to be written, and all slots.
std::vector<Run> runsFor(const Settings& settings, bool keepsHistory, std::span<const ExposedSlot> slots) {
  std::vector<Run> runs;
  while (keepsHistory || !slots.empty()) {
    Run run{keepsHistory, false, {}};
    run.slots = slots.first(std::min(slots.size(), kMostTargets - run.taken(settings)));
    slots = slots.subspan(run.slots.size());
    runs.push_back(run);
    keepsHistory = false;
  }
  return runs;
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

// Where a run draws: into the history, if it writes one, and into the exposure's layers.
std::vector<gl::Attachment> attachments(const Run& run, const History* out, const Exposure* exposure,
                                        const Settings& settings) {
  std::vector<gl::Attachment> targets;
  if (run.keepsHistory) {
    targets = {{&out->color}, {&out->surface}};
    for (const HistoryLayer& layer : historyLayers())
      if (layer.isNeeded(settings)) targets.push_back({&(out->*layer.texture)});
  }
  for (const ExposedSlot& slot : run.slots) targets.push_back({&exposure->textureOf(slot), slot.layer});
  return targets;
}

} // namespace

struct TaaPass::Parts {
  ProgramCache programs{"taa/resolve.frag", "resolve"};
  PassInputs passInputs;
  OutputPass output;

  void bindHistory(gl::RenderPass& pass, const FrameInputs& inputs, const History* previous,
                   const Settings& settings) const;
  void draw(const Run& run, const gl::Framebuffer& target, const FrameInputs& inputs, const History* previous,
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

void TaaPass::Parts::draw(const Run& run, const gl::Framebuffer& target, const FrameInputs& inputs,
                          const History* previous, const Settings& settings, const Exposure* exposure) {
  if (inputs.info.startsHistory) previous = nullptr;
  assert(!previous || previous->color.size() == outputSize(inputs));
  assert(isUpsampled(settings) || outputSize(inputs) == inputs.color.size());
  const Settings relevant = relevantSettings(settings);
  const gl::Program& resolve = programs.program(relevant, run.key(), [&] { return run.prelude(relevant); });
  const gl::Rect region = exposure ? exposure->region() : gl::Rect{};
  passInputs.update(inputs, settings, historyState(previous, settings), {region.x, region.y});

  gl::RenderPass pass(target, {}, "TaaPass");
  pass.program(resolve);
  passInputs.bind(pass, inputs);
  bindHistory(pass, inputs, previous, settings);
  if (run.stores) pass.image(0, exposure->textureOf(run.slots.front()));
  pass.drawFullscreen();
  if (run.stores) gl::imageBarrier();
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
  const auto slots = exposure ? exposure->layout().ofResolve() : std::span<const ExposedSlot>();
  for (const Run& run : runsFor(settings, true, slots)) {
    const gl::Framebuffer target(attachments(run, &out, exposure, settings), nullptr, "resolved");
    parts_->draw(run, target, inputs, previous, settings, exposure);
  }
  if (exposure) parts_->output.fill(inputs, out.color, settings, *exposure);
}

void TaaPass::expose(const FrameInputs& inputs, const History* previous, const History& resolved,
                     const Settings& settings, Exposure& exposure) {
  const gl::Rect& region = exposure.region();
  std::vector<Run> runs = runsFor(settings, false, exposure.layout().ofResolve());
  if (runs.size() > 1 && region.width * region.height <= kSmallRegion)
    runs = {{.keepsHistory = false, .stores = true, .slots = exposure.layout().ofResolve()}};
  for (const Run& run : runs) {
    const gl::Framebuffer target =
        run.stores
            ? gl::Framebuffer(region.width, region.height, "exposed region")
            : gl::Framebuffer(attachments(run, nullptr, &exposure, settings), nullptr, "exposed region");
    parts_->draw(run, target, inputs, previous, settings, &exposure);
  }
  parts_->output.fill(inputs, resolved.color, settings, exposure);
}

void TaaPass::prepare(const Settings& settings, const std::vector<IntermediateId>& watched) {
  const ExposureLayout layout(watched);
  const Settings relevant = relevantSettings(settings);
  for (const Run& run : runsFor(relevant, true, layout.ofResolve()))
    parts_->programs.program(relevant, run.key(), [&] { return run.prelude(relevant); });
  parts_->output.prepare(settings, layout);
}

void TaaPass::reloadShaders() {
  ProgramCache programs = parts_->programs.compiledAnew();
  ProgramCache output = parts_->output.programs.compiledAnew();
  parts_->programs = std::move(programs); // not reached when one of them does not compile
  parts_->output.programs = std::move(output);
}

} // namespace taa
