#include "core/taa/TaaPass.h"

#include "core/taa/OutputPass.h"
#include "core/taa/PassInputs.h"
#include "core/taa/ProgramCache.h"

#include <algorithm>
#include <cassert>
#include <span>
#include <string>
#include <utility>

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

/// One run of the resolve: whether it writes the history, and which slots how.
struct Run {
  bool keepsHistory = false, stores = false, isSparse = false;
  std::span<const ExposedSlot> slots;
  std::optional<gl::Rect> part = {}; ///< none: the whole target

  std::string prelude(const Settings& settings) const {
    return historyPrelude(settings, keepsHistory) + sparsePrelude(isSparse) +
           (stores ? exposeAsStores(slots) : exposeAsTargets(slots, taken(settings)));
  }
  std::string key() const {
    return std::string(keepsHistory ? "history " : "") + (stores ? "stores " : "") +
           (isSparse ? "sparse " : "") + slotsKey(slots);
  }
  std::size_t taken(const Settings& settings) const { return keepsHistory ? historyTargets(settings) : 0; }
};

// Those that write the history, if it is to be written, and all slots.
std::vector<Run> runsFor(const Settings& settings, bool keepsHistory, std::span<const ExposedSlot> slots) {
  std::vector<Run> runs;
  while (keepsHistory || !slots.empty()) {
    Run run;
    run.keepsHistory = keepsHistory;
    run.slots = slots.first(std::min(slots.size(), kMaxTargets - run.taken(settings)));
    slots = slots.subspan(run.slots.size());
    runs.push_back(run);
    keepsHistory = false;
  }
  return runs;
}

std::vector<Run> exposingRuns(const Settings& settings, const ExposedRows& exposedRows) {
  const glm::ivec2& texels = exposedRows.texels();
  std::vector<Run> runs = runsFor(settings, false, exposedRows.layout().ofResolve());
  if (runs.size() > 1 && texels.x * texels.y <= kFewTexels)
    runs = {{.stores = true, .slots = exposedRows.layout().ofResolve()}};
  for (Run& run : runs) run.isSparse = exposedRows.isSparse();
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

// Where a run draws: into the history, if it writes one, and into the layers of exposed rows.
std::vector<gl::Attachment> attachments(const Run& run, const History* out, const ExposedRows* exposedRows,
                                        const Settings& settings) {
  std::vector<gl::Attachment> targets;
  if (run.keepsHistory) {
    targets = {{&out->color}, {&out->surface}};
    for (const HistoryLayer& layer : historyLayers())
      if (layer.isNeeded(settings)) targets.push_back({&(out->*layer.texture)});
  }
  for (const ExposedSlot& slot : run.slots) targets.push_back({&exposedRows->textureOf(slot), slot.layer});
  return targets;
}

// With textures that are not swapped the next frame goes on from the color before this one's.
void keepStale(const FrameInputs& inputs, const History* previous, History& out) {
  if (!out.stale) return;
  // None, or of other settings: there is nothing to go on from.
  const bool isFirst = !previous || inputs.info.startsHistory || previous->color.size() != out.stale.size() ||
                       previous->color.format() != out.stale.format();
  out.stale.copyFrom(isFirst ? out.color : previous->color);
}

} // namespace

struct TaaPass::Impl {
  ProgramCache programs{"taa/resolve.frag", "resolve"};
  PassInputs passInputs;
  OutputPass output;

  void bindHistory(gl::RenderPass& pass, const FrameInputs& inputs, const History* previous,
                   const Settings& settings) const;
  void draw(const Run& run, const gl::Framebuffer& target, const FrameInputs& inputs, const History* previous,
            const Settings& settings, const ExposedRows* exposedRows);
};

void TaaPass::Impl::bindHistory(gl::RenderPass& pass, const FrameInputs& inputs, const History* previous,
                                const Settings& settings) const {
  // Without history the shader uses nothing of what it reads there, but the reads want a texture of this
  // size.
  pass.texture(6, previous ? previous->readColor() : inputs.color, passInputs.nearest());
  pass.texture(7, previous ? previous->surface : inputs.motion, passInputs.nearest());
  unsigned unit = kFirstLayerUnit;
  for (const HistoryLayer& layer : historyLayers()) {
    const bool isHeld = previous && previous->*layer.texture;
    if (layer.isNeeded(settings))
      pass.texture(unit, isHeld ? previous->*layer.texture : inputs.motion, passInputs.nearest());
    ++unit;
  }
}

void TaaPass::Impl::draw(const Run& run, const gl::Framebuffer& target, const FrameInputs& inputs,
                         const History* previous, const Settings& settings, const ExposedRows* exposedRows) {
  if (inputs.info.startsHistory) previous = nullptr;
  assert(!previous || previous->color.size() == outputSize(inputs));
  assert(isUpsampled(settings) || outputSize(inputs) == inputs.color.size());
  const Settings relevant = relevantSettings(settings);
  const gl::Program& resolve = programs.program(relevant, run.key(), [&] { return run.prelude(relevant); });
  passInputs.update(inputs, settings, historyState(previous, settings),
                    exposedRows ? TargetPixels{exposedRows->region(), exposedRows->texels()}
                                : TargetPixels{});

  gl::RenderPass pass(target, {.scissor = run.part}, "TaaPass");
  pass.program(resolve);
  passInputs.bind(pass, inputs);
  bindHistory(pass, inputs, previous, settings);
  if (run.stores) pass.image(0, exposedRows->textureOf(run.slots.front()));
  pass.drawFullscreen();
  if (run.stores) gl::imageBarrier();
}

TaaPass::TaaPass() : impl_(std::make_unique<Impl>()) {}
TaaPass::~TaaPass() = default;
TaaPass::TaaPass(TaaPass&&) noexcept = default;
TaaPass& TaaPass::operator=(TaaPass&&) noexcept = default;

void TaaPass::resolve(const FrameInputs& inputs, const History* previous, const Settings& settings,
                      History& out, ExposedRows* exposedRows) {
  assert(&out != previous);
  const gl::TextureSize size = outputSize(inputs);
  assert(!exposedRows || exposedRows->region() == (gl::Rect{0, 0, size.width, size.height}));
  fitHistory(out, size.width, size.height, settings);
  const auto slots = exposedRows ? exposedRows->layout().ofResolve() : std::span<const ExposedSlot>();
  for (const Run& run : runsFor(settings, true, slots)) {
    const gl::Framebuffer target(attachments(run, &out, exposedRows, settings), nullptr, "resolved");
    impl_->draw(run, target, inputs, previous, settings, exposedRows);
  }
  keepStale(inputs, previous, out);
  if (!exposedRows) return;
  impl_->output.fill(inputs, out.color, settings, *exposedRows);
  exposedRows->readFrom(&inputs, out);
}

void TaaPass::resolvePart(const FrameInputs& inputs, const History* previous, const Settings& settings,
                          History& out, const gl::Rect& part) {
  assert(&out != previous);
  fitHistory(out, outputSize(inputs).width, outputSize(inputs).height, settings);
  const Run run{.keepsHistory = true, .slots = {}, .part = part};
  const gl::Framebuffer target(attachments(run, &out, nullptr, settings), nullptr, "resolved part");
  impl_->draw(run, target, inputs, previous, settings, nullptr);
  keepStale(inputs, previous, out);
}

void TaaPass::expose(const FrameInputs& inputs, const History* previous, const History& resolved,
                     const Settings& settings, ExposedRows& exposedRows) {
  const glm::ivec2& texels = exposedRows.texels();
  for (const Run& run : exposingRuns(settings, exposedRows)) {
    const gl::Framebuffer target =
        run.stores
            ? gl::Framebuffer(texels.x, texels.y, "exposed region")
            : gl::Framebuffer(attachments(run, nullptr, &exposedRows, settings), nullptr, "exposed region");
    impl_->draw(run, target, inputs, previous, settings, &exposedRows);
  }
  impl_->output.fill(inputs, resolved.color, settings, exposedRows);
  exposedRows.readFrom(&inputs, resolved);
}

void TaaPass::prepare(const Settings& settings, const std::vector<IntermediateId>& watched) {
  const ExposedLayout layout(watched, rowSources(settings));
  const Settings relevant = relevantSettings(settings);
  for (const Run& run : runsFor(relevant, true, layout.ofResolve()))
    impl_->programs.program(relevant, run.key(), [&] { return run.prelude(relevant); });
  impl_->output.prepare(settings, layout);
}

bool TaaPass::isPrepared(const Settings& settings, const std::vector<IntermediateId>& watched) const {
  const ExposedLayout layout(watched, rowSources(settings));
  const Settings relevant = relevantSettings(settings);
  return std::ranges::all_of(runsFor(relevant, true, layout.ofResolve()),
                             [&](const Run& run) { return impl_->programs.holds(relevant, run.key()); });
}

bool TaaPass::isPrepared(const Settings& settings, const ExposedRows& exposedRows) const {
  const Settings relevant = relevantSettings(settings);
  return std::ranges::all_of(exposingRuns(settings, exposedRows),
                             [&](const Run& run) { return impl_->programs.holds(relevant, run.key()); });
}

void TaaPass::reloadShaders() {
  ProgramCache programs = impl_->programs.compiledAnew();
  ProgramCache output = impl_->output.programs.compiledAnew();
  impl_->programs = std::move(programs); // not reached when one of them does not compile
  impl_->output.programs = std::move(output);
}

} // namespace taa
