#include "core/picture/Visualizer.h"

#include "core/base/Error.h"
#include "core/gl/Context.h"
#include "core/gl/RenderPass.h"
#include "core/picture/ColorMap.h"
#include "shaders/shared/ViewBlock.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <map>
#include <string_view>
#include <tuple>
#include <utility>

namespace taa {

/// What kind of texture a layer is read from.
enum class Reading : std::uint8_t { Array, Plain, Integers };

/// The textures in the order of their units; 1 has the color maps.
struct LayerUnit {
  unsigned unit;
  std::string_view name;
  Layer DrawnLayers::*layer;
};
constexpr LayerUnit kLayerUnits[] = {{0, "layer", &DrawnLayers::row},
                                     {2, "minus", &DrawnLayers::minus},
                                     {3, "rejectReason", &DrawnLayers::rejectReason},
                                     {4, "objectId", &DrawnLayers::objectId}};
using Readings = std::array<Reading, std::size(kLayerUnits)>;

/// What a program is made for: all that decides which of its branches are taken.
struct VisualVariant {
  Visual visual = Visual::Color;
  int channels = 1, alone = -1;
  ColorMap map = ColorMap::Gray;
  bool marksInvalid = true, isAveraged = false;
  bool isDifference = false, marksClipped = false, tintsRejected = false, outlines = false, hasArrows = false;
  bool isPartial = false, isMinusPartial = false, hasVectors = false;
  Readings readings{};

  auto key() const {
    return std::tuple(visual, channels, alone, map, marksInvalid, isAveraged, isDifference, marksClipped,
                      tintsRejected, outlines, hasArrows, isPartial, isMinusPartial, hasVectors, readings);
  }
  bool operator<(const VisualVariant& other) const { return key() < other.key(); }
};

namespace {

constexpr std::array<std::string_view, 10> kVisuals = {"Color",  "Box",      "Depth",  "Scalar", "Signed",
                                                       "Vector", "Position", "Normal", "Mask",   "Index"};
constexpr std::size_t kKeptTargets = 4; // viewports of as many sizes are drawn in turn

// Half of the longest arrow, share of its cell, and half of the shortest one that is no dot, units.
constexpr float kArrowReach = 0.45f, kMinReach = 2.0f;

Readings readingsOf(const DrawnLayers& layers) {
  Readings readings{};
  for (std::size_t index = 0; index < std::size(kLayerUnits); ++index) {
    const gl::Texture* texture = (layers.*kLayerUnits[index].layer).texture;
    if (!texture || texture->size().layers > 0) continue;
    readings[index] = texture->format() == gl::Format::R32UI ? Reading::Integers : Reading::Plain;
  }
  return readings;
}

// The textures, and fetch_<name>(texel, layer) of each.
std::string samplers(const Readings& readings) {
  std::string text;
  for (std::size_t index = 0; index < std::size(kLayerUnits); ++index) {
    const Reading reading = readings[index];
    const std::string name(kLayerUnits[index].name);
    const std::string_view type = reading == Reading::Array   ? "sampler2DArray"
                                  : reading == Reading::Plain ? "sampler2D"
                                                              : "usampler2D";
    text.append("layout(binding = " + std::to_string(kLayerUnits[index].unit) + ") uniform ");
    text.append(type).append(" u_" + name + ";\n#define fetch_" + name + "(texel, layer) vec4(texelFetch(u_");
    text += name + (reading == Reading::Array ? ", ivec3(texel, layer), 0))\n" : ", texel, 0))\n");
  }
  return text;
}

std::string prelude(const VisualVariant& variant) {
  std::string text = samplers(variant.readings);
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
  add("bool", "kIsAveraged", variant.isAveraged);
  add("bool", "kIsDifference", variant.isDifference);
  add("bool", "kMarksClipped", variant.marksClipped);
  add("bool", "kTintsRejected", variant.tintsRejected);
  add("bool", "kOutlines", variant.outlines);
  add("bool", "kHasArrows", variant.hasArrows);
  add("bool", "kIsPartial", variant.isPartial);
  add("bool", "kIsMinusPartial", variant.isMinusPartial);
  add("bool", "kHasVectors", variant.hasVectors);
  return text;
}

gl::Program compileVisual(const VisualVariant& variant) {
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
VisualVariant variantOf(const DrawnLayers& layers, const Intermediate& row, const ViewStyle& style,
                        const ViewTransform& transform) {
  const bool isDifference = layers.minus.texture != nullptr;
  return {.visual = isDifference ? Visual::Signed : row.visual,
          .channels = row.channels,
          .alone = isDifference ? -1 : channelAlone(row, style),
          .map = style.map,
          .marksInvalid = style.markInvalid,
          .isAveraged = transform.zoom < kSharpZoom && transform.zoom != std::floor(transform.zoom),
          .isDifference = isDifference,
          .marksClipped = style.markClipped,
          .tintsRejected = style.markRejected && layers.rejectReason.texture,
          .outlines = style.outlineObjects && layers.objectId.texture,
          .hasArrows = style.arrows && row.visual == Visual::Vector && !isDifference,
          .isPartial = layers.row.isPartial,
          .isMinusPartial = layers.minus.isPartial,
          .hasVectors = row.visual == Visual::Vector,
          .readings = readingsOf(layers)};
}

// Screen pixels of what is laid over the picture: whole ones, so that lines stay sharp.
float unitOf(const ViewTransform& transform) {
  return std::max(1.0f, std::round(transform.scale));
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
  block.above = {kAboveColor[0], kAboveColor[1], kAboveColor[2], unitOf(transform)};
  block.below = {kBelowColor[0], kBelowColor[1], kBelowColor[2], kTintShare};
  block.nothing = {kNothingLight[0], kNothingLight[1], kNothingSide, 0.0f};
  block.arrows = {kArrowSpacing, kLongestArrow, kArrowReach, kMinReach};
  return block;
}

} // namespace

struct Visualizer::Impl {
  struct Target {
    gl::Texture texture;
    gl::Framebuffer framebuffer;
  };
  std::map<VisualVariant, gl::Program> programs; // compiled when first used
  gl::Texture colorMaps = uploadColorMaps();
  gl::Sampler sampler{gl::SamplerState{}};
  gl::Buffer blocks{sizeof(shared::ViewBlock), nullptr, "ViewBlock"};
  std::vector<Target> targets; // the one used last at the end

  const gl::Program& program(const VisualVariant& variant);
  Target& target(int width, int height);
};

const gl::Program& Visualizer::Impl::program(const VisualVariant& variant) {
  const auto found = programs.find(variant);
  return found != programs.end() ? found->second
                                 : programs.emplace(variant, compileVisual(variant)).first->second;
}

Visualizer::Impl::Target& Visualizer::Impl::target(int width, int height) {
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

Visualizer::Visualizer() : impl_(std::make_unique<Impl>()) {}
Visualizer::~Visualizer() = default;
Visualizer::Visualizer(Visualizer&&) noexcept = default;
Visualizer& Visualizer::operator=(Visualizer&&) noexcept = default;

Picture Visualizer::draw(const gl::Texture& texture, int layer, int firstChannel, const Intermediate& row,
                         const ViewStyle& style, const ViewTransform& transform, int width, int height) {
  return draw(DrawnLayers{.row = {&texture, layer, firstChannel}}, row, style, transform, width, height);
}

Picture Visualizer::draw(const DrawnLayers& layers, const Intermediate& row, const ViewStyle& style,
                         const ViewTransform& transform, int width, int height) {
  assert(layers.row.texture);
  assert(width > 0 && height > 0 && transform.zoom > 0.0f);
  const gl::Program& program = impl_->program(variantOf(layers, row, style, transform));
  const Impl::Target& target = impl_->target(width, height);
  const shared::ViewBlock values = block(layers, style, transform);
  impl_->blocks.update(0, &values, sizeof(values));
  {
    gl::RenderPass pass(target.framebuffer, {}, "Visualizer");
    pass.program(program);
    pass.texture(1, impl_->colorMaps, impl_->sampler);
    for (const LayerUnit& unit : kLayerUnits)
      if (const gl::Texture* drawn = (layers.*unit.layer).texture)
        pass.texture(unit.unit, *drawn, impl_->sampler);
    pass.uniformBlock(3, impl_->blocks);
    pass.drawFullscreen();
  }
  Picture picture{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height * 4)};
  target.texture.downloadBytes(picture.rgba);
  return picture;
}

Visualizer Visualizer::reloaded() const {
  Visualizer fresh;
  for (const auto& [variant, program] : impl_->programs) fresh.impl_->program(variant);
  return fresh;
}

// As pointed() in shaders/inspect/visualize.frag.
ArrowScale arrowScale(const ViewTransform& transform) {
  const float texels = std::ceil(kArrowSpacing * unitOf(transform) / transform.zoom);
  const float cell = texels * transform.zoom / unitOf(transform);
  const float reach = kArrowReach * std::min(cell, kLongestArrow);
  return {2.0f * reach, std::min(1.0f, kMinReach / reach)};
}

namespace {

/// Whether the row is the size of an error.
bool isErrorSize(IntermediateId id) {
  switch (id) {
  case IntermediateId::referenceErrorAbs:
  case IntermediateId::engineDifferenceAbs:
  case IntermediateId::relativeError:
  case IntermediateId::flip:
  case IntermediateId::ssimMap:
  case IntermediateId::ghost:
    return true;
  default:
    return false;
  }
}

} // namespace

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
  if (isErrorSize(row.id)) style.map = ColorMap::Inferno; // dark: as it should be
  return style;
}

ViewStyle differenceStyle(const Intermediate& row) {
  ViewStyle style = defaultStyle(row);
  const float span = row.high - row.low;
  style.high = span > 0.0f ? span / 4.0f : 1.0f;
  style.low = -style.high;
  style.map = ColorMap::Diverging;
  return style;
}

} // namespace taa
