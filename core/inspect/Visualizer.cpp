#include "core/inspect/Visualizer.h"

#include "core/base/Error.h"
#include "core/gl/Context.h"
#include "core/gl/RenderPass.h"
#include "core/inspect/ColorMap.h"
#include "shaders/shared/ViewBlock.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace taa {

namespace {

constexpr std::array<std::string_view, 10> kVisuals = {"Color",  "Box",      "Depth",  "Scalar", "Signed",
                                                       "Vector", "Position", "Normal", "Mask",   "Index"};
constexpr std::size_t kKeptTargets = 4; // viewports of as many sizes are drawn in turn

/// What a program is made for: all that decides which of its branches are taken.
struct Variant {
  Visual visual = Visual::Color;
  int channels = 1, alone = -1;
  ColorMap map = ColorMap::Gray;
  bool marksInvalid = true, isMinified = false;
  bool isDifference = false, marksClipped = false, tintsRejected = false, outlines = false, hasArrows = false;

  auto key() const {
    return std::tuple(visual, channels, alone, map, marksInvalid, isMinified, isDifference, marksClipped,
                      tintsRejected, outlines, hasArrows);
  }
  bool operator<(const Variant& other) const { return key() < other.key(); }
};

std::string prelude(const Variant& variant) {
  std::string text;
  const auto add = [&](std::string_view type, std::string_view name, int value) {
    text.append("const ").append(type).append(" ").append(name);
    text += " = " + std::string(type) + "(" + std::to_string(value) + ");\n";
  };
  for (std::size_t index = 0; index < kVisuals.size(); ++index)
    add("int", "kVisual_" + std::string(kVisuals[index]), static_cast<int>(index));
  add("int", "kVisual", static_cast<int>(variant.visual));
  add("int", "kChannels", variant.channels);
  add("int", "kAlone", variant.alone);
  add("int", "kMap", static_cast<int>(variant.map));
  add("bool", "kMarksInvalid", variant.marksInvalid);
  add("bool", "kIsMinified", variant.isMinified);
  add("bool", "kIsDifference", variant.isDifference);
  add("bool", "kMarksClipped", variant.marksClipped);
  add("bool", "kTintsRejected", variant.tintsRejected);
  add("bool", "kOutlines", variant.outlines);
  add("bool", "kHasArrows", variant.hasArrows);
  return text;
}

gl::Program compile(const Variant& variant) {
  const auto index = static_cast<std::size_t>(variant.visual);
  return {gl::ShaderSource("include/fullscreen.vert"),
          gl::ShaderSource("inspect/visualize.frag", prelude(variant)),
          "Visualizer " + std::string(kVisuals[index])};
}

gl::Texture uploadColorMaps() {
  gl::Texture texture({.width = kColorMapEntries, .height = kColorMapCount}, gl::Format::RGBA32F,
                      "color maps");
  texture.upload(colorMapTable());
  return texture;
}

// The one channel that is shown, or −1: none, several, or the row has only one.
int channelAlone(const Intermediate& row, const ViewStyle& style) {
  if (row.channels == 1) return -1;
  const std::array<bool, 3> shown = {style.red, style.green, style.blue && row.channels > 2};
  if (std::ranges::count(shown, true) != 1) return -1;
  return static_cast<int>(std::ranges::find(shown, true) - shown.begin());
}

// The branches that a picture takes. A difference is a signed value, whatever the row is.
Variant variantOf(const DrawnLayers& layers, const Intermediate& row, const ViewStyle& style,
                  const ViewTransform& transform) {
  const bool isDifference = layers.minus.texture != nullptr;
  return {.visual = isDifference ? Visual::Signed : row.visual,
          .channels = row.channels,
          .alone = isDifference ? -1 : channelAlone(row, style),
          .map = style.map,
          .marksInvalid = style.markInvalid,
          .isMinified = transform.zoom < 1.0f,
          .isDifference = isDifference,
          .marksClipped = style.markClipped,
          .tintsRejected = style.markRejected && layers.rejectReason.texture,
          .outlines = style.outlineObjects && layers.objectId.texture,
          .hasArrows = style.arrows && row.visual == Visual::Vector && !isDifference};
}

shared::ViewBlock block(const DrawnLayers& layers, const ViewStyle& style, const ViewTransform& transform) {
  const float span = style.high - style.low;
  shared::ViewBlock block;
  block.sizePx = {layers.row.texture->width(), layers.row.texture->height()};
  block.originPx = transform.origin;
  // An empty range is a step at its value.
  block.range = {style.low, span != 0.0f ? span : 1e-30f, std::exp2(style.exposure), transform.zoom};
  block.channels = {style.red, style.green, style.blue, 0};
  block.layer = {layers.row.layer, layers.row.firstChannel, layers.minus.layer, layers.minus.firstChannel};
  block.overlays = {layers.rejectReason.layer, layers.rejectReason.firstChannel, layers.objectId.layer,
                    layers.objectId.firstChannel};
  block.above = {kAboveColor[0], kAboveColor[1], kAboveColor[2], std::max(1.0f, std::round(transform.scale))};
  block.below = {kBelowColor[0], kBelowColor[1], kBelowColor[2], kTintShare};
  block.arrows = {kArrowSpacing, kLongestArrow, 0.0f, 0.0f};
  return block;
}

} // namespace

struct Visualizer::Parts {
  struct Target {
    gl::Texture texture;
    gl::Framebuffer framebuffer;
  };
  std::map<Variant, gl::Program> programs; // compiled when first used
  gl::Texture colorMaps = uploadColorMaps();
  gl::Sampler sampler{gl::SamplerState{}};
  gl::Buffer blocks{sizeof(shared::ViewBlock), nullptr, "ViewBlock"};
  std::vector<Target> targets; // the one used last at the end

  const gl::Program& program(const Variant& variant);
  Target& target(int width, int height);
};

const gl::Program& Visualizer::Parts::program(const Variant& variant) {
  const auto found = programs.find(variant);
  return found != programs.end() ? found->second : programs.emplace(variant, compile(variant)).first->second;
}

Visualizer::Parts::Target& Visualizer::Parts::target(int width, int height) {
  const auto fits = [&](const Target& target) {
    return target.texture.width() == width && target.texture.height() == height;
  };
  const auto found = std::ranges::find_if(targets, fits);
  if (found != targets.end()) {
    std::rotate(found, found + 1, targets.end());
    return targets.back();
  }
  Target fresh;
  fresh.texture = gl::Texture({.width = width, .height = height}, gl::Format::RGBA8, "viewport");
  fresh.framebuffer = gl::Framebuffer({{&fresh.texture}}, nullptr, "viewport");
  if (targets.size() == kKeptTargets) targets.erase(targets.begin());
  targets.push_back(std::move(fresh));
  return targets.back();
}

Visualizer::Visualizer() : parts_(std::make_unique<Parts>()) {}
Visualizer::~Visualizer() = default;
Visualizer::Visualizer(Visualizer&&) noexcept = default;
Visualizer& Visualizer::operator=(Visualizer&&) noexcept = default;

Picture Visualizer::draw(const gl::Texture& texture, int layer, int firstChannel, const Intermediate& row,
                         const ViewStyle& style, const ViewTransform& transform, int width, int height) {
  return draw(DrawnLayers{.row = {&texture, layer, firstChannel}}, row, style, transform, width, height);
}

Picture Visualizer::draw(const DrawnLayers& layers, const Intermediate& row, const ViewStyle& style,
                         const ViewTransform& transform, int width, int height) {
  assert(layers.row.texture && layers.row.texture->size().layers > layers.row.layer);
  assert(width > 0 && height > 0 && transform.zoom > 0.0f);
  const gl::Program& program = parts_->program(variantOf(layers, row, style, transform));
  const Parts::Target& target = parts_->target(width, height);
  const shared::ViewBlock values = block(layers, style, transform);
  parts_->blocks.update(0, &values, sizeof(values));
  {
    gl::RenderPass pass(target.framebuffer, {}, "Visualizer");
    pass.program(program);
    pass.texture(0, *layers.row.texture, parts_->sampler);
    pass.texture(1, parts_->colorMaps, parts_->sampler);
    const std::pair<int, const Layer*> others[] = {
        {2, &layers.minus}, {3, &layers.rejectReason}, {4, &layers.objectId}};
    for (const auto& [unit, other] : others)
      if (other->texture) pass.texture(unit, *other->texture, parts_->sampler);
    pass.uniformBlock(3, parts_->blocks);
    pass.drawFullscreen();
  }
  Picture picture{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height * 4)};
  target.texture.downloadBytes(picture.rgba);
  return picture;
}

Visualizer Visualizer::reloaded() const {
  Visualizer fresh;
  for (const auto& [variant, program] : parts_->programs) fresh.parts_->program(variant);
  return fresh;
}

ViewStyle defaultStyle(const Intermediate& row) {
  ViewStyle style;
  style.low = row.low;
  style.high = row.high;
  switch (row.visual) {
  case Visual::Color:
  case Visual::Box:
  case Visual::Mask:
    style.map = ColorMap::Gray;
    break;
  case Visual::Depth:
  case Visual::Scalar:
  case Visual::Position:
    style.map = ColorMap::Viridis;
    break;
  case Visual::Signed:
  case Visual::Vector:
  case Visual::Normal:
    style.map = ColorMap::Diverging;
    break;
  case Visual::Index:
    style.map = ColorMap::Categorical;
    break;
  }
  if (row.id == IntermediateId::referenceErrorAbs) style.map = ColorMap::Inferno; // dark: as it should be
  return style;
}

} // namespace taa
