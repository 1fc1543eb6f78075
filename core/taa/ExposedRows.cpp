// Textures that hold the watched intermediates of a region.
#include "core/taa/TaaPass.h"

#include <algorithm>
#include <cassert>
#include <string>
#include <utility>
#include <vector>

namespace taa {

namespace {

constexpr int kChannelCounts[] = {1, 2, 4};

gl::Format formatOf(int channels) {
  return channels == 1 ? gl::Format::R32F : channels == 2 ? gl::Format::RG32F : gl::Format::RGBA32F;
}

gl::Texture makeLayers(const ExposedLayout& layout, const glm::ivec2& texels, int channels) {
  const int layers = layout.layers(channels);
  if (layers == 0) return {};
  gl::Texture texture({texels.x, texels.y, layers}, formatOf(channels),
                      "exposed " + std::to_string(channels));
  texture.clear(0.0f, 0.0f, 0.0f, 0.0f);
  return texture;
}

} // namespace

ExposedRows::ExposedRows(std::vector<IntermediateId> watched, const gl::Rect& region,
                         const glm::ivec2& texels)
    : layout_(std::move(watched)), region_(region),
      texels_(texels.x > 0 ? texels : glm::ivec2(region.width, region.height)) {
  one_ = makeLayers(layout_, texels_, 1);
  two_ = makeLayers(layout_, texels_, 2);
  four_ = makeLayers(layout_, texels_, 4);
}

ExposedRows::ExposedRows(ExposedLayout layout, const gl::Rect& picture)
    : layout_(std::move(layout)), region_(picture), texels_(picture.width, picture.height) {
  one_ = makeLayers(layout_, texels_, 1);
  two_ = makeLayers(layout_, texels_, 2);
  four_ = makeLayers(layout_, texels_, 4);
  for (const ExposedSlot& slot : layout_.constants()) fill(slot);
}

void ExposedRows::fill(const ExposedSlot& slot) {
  gl::Framebuffer({{&textureOf(slot), slot.layer}}, nullptr, "constant rows")
      .clearColor(0, glm::vec4(*slot.constant));
}

void ExposedRows::take(const ExposedLayout& layout) {
  assert(layout_.hasSamePlaces(layout));
  for (std::size_t index = 0; index < layout.constants().size(); ++index)
    if (layout.constants()[index].constant != layout_.constants()[index].constant)
      fill(layout.constants()[index]);
  layout_ = layout;
}

void ExposedRows::readFrom(const FrameInputs* inputs, const History& resolved) {
  assert(inputs || !layout_.needsInputs());
  inputs_ = inputs;
  resolved_ = &resolved;
}

const gl::Texture& ExposedRows::texture(IntermediateId id) const {
  assert(holds(id));
  const HeldRow* row = layout_.held(id);
  if (!row) return textureOf(layout_.slot(id));
  return row->input ? inputs_->*row->input : resolved_->*row->history;
}

std::size_t exposedBytes(const ExposedLayout& layout, const gl::Rect& region) {
  std::size_t sum = 0;
  for (const int channels : kChannelCounts)
    sum += static_cast<std::size_t>(layout.layers(channels)) *
           gl::textureBytes({region.width, region.height}, formatOf(channels));
  return sum;
}

const gl::Texture& ExposedRows::textureOf(const ExposedSlot& slot) const {
  return slot.channels == 1 ? one_ : slot.channels == 2 ? two_ : four_;
}

Image ExposedRows::image(IntermediateId id) const {
  return image(id, {0, 0, texels_.x, texels_.y});
}

Image ExposedRows::image(IntermediateId id, const gl::Rect& part) const {
  Image stored = texture(id).download(part, layer(id));
  const int channels = intermediate(id).channels, first = firstChannel(id);
  if (channels == stored.channels) return stored;
  Image image(stored.width, stored.height, channels);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) std::copy_n(stored.at(x, y) + first, channels, image.at(x, y));
  return image;
}

} // namespace taa
