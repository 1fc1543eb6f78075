#include "core/taa/TaaPass.h"

#include "core/gl/Buffer.h"
#include "core/gl/Program.h"
#include "core/settings/Parameters.h"
#include "shaders/shared/ResolveBlock.h"

#include <algorithm>
#include <cassert>
#include <map>

namespace taa {

namespace {

// Programs kept besides those in use: enough for a lane's choices to be flipped back and forth.
constexpr std::size_t kMostPrograms = 32;
// A program that was not used in this many runs is compiled again only when it is needed again.
constexpr std::uint64_t kRunsInUse = 16;

// Units of shaders/taa/inputs.glsl for what a frame may be without.
constexpr unsigned kMaskUnit = 14, kOverlayUnit = 15;

using Watched = std::vector<IntermediateId>;

struct Variant {
  std::string prelude;
  gl::Program program;
  std::uint64_t lastUse = 0;
};

gl::Program compile(const std::string& prelude) {
  return gl::Program(gl::ShaderSource("include/fullscreen.vert"),
                     gl::ShaderSource("taa/resolve.frag", prelude), "resolve");
}

shared::ResolveBlock makeBlock(const FrameInputs& inputs, const Settings& settings, bool hasHistory,
                               const gl::Rect& region) {
  const std::array<float, 9> w = currentFilterWeights(settings.current, inputs.info.jitterPx);
  shared::ResolveBlock block{};
  block.sizePx = glm::vec2(static_cast<float>(inputs.width()), static_cast<float>(inputs.height()));
  block.jitterPx = inputs.info.jitterPx;
  block.depthTerms = inputs.block.depthTerms;
  block.currentWeights0 = glm::vec4(w[0], w[1], w[2], 0.0f);
  block.currentWeights1 = glm::vec4(w[3], w[4], w[5], 0.0f);
  block.currentWeights2 = glm::vec4(w[6], w[7], w[8], 0.0f);
  block.state = glm::ivec4(hasHistory ? 1 : 0, region.x, region.y, inputs.info.frame);
  return block;
}

// What is read where a frame has no mask and no overlay.
gl::Texture blackTexel() {
  gl::Texture texture({.width = 1, .height = 1}, gl::Format::RGBA8, "nothing");
  texture.clear(0.0f, 0.0f, 0.0f, 0.0f);
  return texture;
}

// Where the resolve draws: into the history, if there is one to write, and into the exposure's targets.
std::vector<gl::Attachment> attachments(const History* out, const Exposure* exposure) {
  std::vector<gl::Attachment> targets(kHistoryTargets);
  if (out) targets = {{&out->color}, {&out->surface}};
  if (exposure && exposesAsTargets(exposure->watched()))
    for (const IntermediateId id : exposure->watched())
      targets.push_back({&exposure->texture(id), exposure->layer(id)});
  return targets;
}

} // namespace

struct TaaPass::Parts {
  gl::Sampler nearest{gl::SamplerState{}};
  gl::Texture nothing = blackTexel();
  gl::Buffer resolveBlock{sizeof(shared::ResolveBlock), nullptr, "ResolveBlock"};
  gl::Buffer settingsBlock{taa::settingsBlock(Settings{}).size(), nullptr, "SettingsBlock"};
  std::map<std::string, Variant> variants; // by what their prelude depends on
  std::uint64_t runs = 0;

  const gl::Program& program(const Settings& settings, const Watched& watched);
  void dropOldest();
  void run(const gl::Framebuffer& target, const FrameInputs& inputs, const History* previous,
           const Settings& settings, const Exposure* exposure);
};

const gl::Program& TaaPass::Parts::program(const Settings& settings, const Watched& watched) {
  std::string key = programKey(settings);
  for (const IntermediateId id : watched) key += std::to_string(static_cast<int>(id)) + ",";
  const auto found = variants.find(key);
  Variant& variant = found != variants.end() ? found->second : [&]() -> Variant& {
    Variant made;
    made.prelude = glslPrelude(settings) + exposePrelude(watched);
    made.program = compile(made.prelude);
    dropOldest();
    return variants[key] = std::move(made);
  }();
  variant.lastUse = ++runs;
  return variant.program;
}

void TaaPass::Parts::dropOldest() {
  if (variants.size() < kMostPrograms) return;
  variants.erase(
      std::ranges::min_element(variants, {}, [](const auto& entry) { return entry.second.lastUse; }));
}

void TaaPass::Parts::run(const gl::Framebuffer& target, const FrameInputs& inputs, const History* previous,
                         const Settings& settings, const Exposure* exposure) {
  const bool hasHistory = previous && !inputs.info.startsHistory;
  assert(!hasHistory || previous->color.size() == inputs.color.size());
  const gl::Program& resolve = program(settings, exposure ? exposure->watched() : Watched{});
  const shared::ResolveBlock block =
      makeBlock(inputs, settings, hasHistory, exposure ? exposure->region() : gl::Rect{});
  const std::vector<std::byte> numbers = taa::settingsBlock(settings);
  resolveBlock.update(0, &block, sizeof(block));
  settingsBlock.update(0, numbers.data(), numbers.size());

  gl::RenderPass pass(target, {}, "TaaPass");
  pass.program(resolve);
  pass.uniformBlock(0, resolveBlock);
  pass.uniformBlock(1, settingsBlock);
  // Without history the shader uses nothing of what it reads there, but the reads want a texture of this
  // size.
  const gl::Texture* textures[] = {&inputs.color,
                                   &inputs.depth,
                                   &inputs.motion,
                                   &inputs.normal,
                                   &inputs.objectId,
                                   &inputs.previousDepth,
                                   hasHistory ? &previous->color : &inputs.color,
                                   hasHistory ? &previous->surface : &inputs.motion};
  for (unsigned unit = 0; unit < std::size(textures); ++unit) pass.texture(unit, *textures[unit], nearest);
  pass.texture(kMaskUnit, inputs.mask ? inputs.mask : nothing, nearest);
  pass.texture(kOverlayUnit, inputs.overlay ? inputs.overlay : nothing, nearest);
  const bool stores = exposure && !exposesAsTargets(exposure->watched());
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
  assert(!exposure || exposure->region() == (gl::Rect{0, 0, inputs.width(), inputs.height()}));
  fitHistory(out, inputs.width(), inputs.height(), settings.history.precision);
  const gl::Framebuffer target(attachments(&out, exposure), nullptr, "resolved");
  parts_->run(target, inputs, previous, settings, exposure);
}

void TaaPass::expose(const FrameInputs& inputs, const History* previous, const Settings& settings,
                     Exposure& exposure) {
  if (exposure.watched().empty()) return;
  const gl::Rect& region = exposure.region();
  const gl::Framebuffer target =
      exposesAsTargets(exposure.watched())
          ? gl::Framebuffer(attachments(nullptr, &exposure), nullptr, "exposed region")
          : gl::Framebuffer(region.width, region.height, "exposed region");
  parts_->run(target, inputs, previous, settings, &exposure);
}

void TaaPass::prepare(const Settings& settings, const std::vector<IntermediateId>& watched) {
  parts_->program(settings, inTableOrder(watched));
}

void TaaPass::reloadShaders() {
  std::map<std::string, Variant> compiled;
  for (const auto& [key, variant] : parts_->variants) {
    if (variant.lastUse + kRunsInUse < parts_->runs) continue;
    compiled[key] = {variant.prelude, compile(variant.prelude), variant.lastUse};
  }
  parts_->variants = std::move(compiled); // not reached when one of them does not compile
}

} // namespace taa
