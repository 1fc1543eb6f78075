// Textures that hold the watched intermediates of a region.
#include "core/taa/TaaPass.h"

#include <algorithm>
#include <cassert>

namespace taa {

namespace {

// Rows of three channels are stored in four: GL has no image format of three floats.
int storedChannels(IntermediateId id) {
  const int channels = intermediate(id).channels;
  return channels == 3 ? 4 : channels;
}

gl::Format formatOf(int channels) {
  return channels == 1 ? gl::Format::R32F : channels == 2 ? gl::Format::RG32F : gl::Format::RGBA32F;
}

gl::Texture makeLayers(const std::vector<IntermediateId>& watched, const gl::Rect& region, int channels) {
  const auto layers = std::ranges::count(watched, channels, storedChannels);
  if (layers == 0) return {};
  gl::Texture texture({region.width, region.height, static_cast<int>(layers)}, formatOf(channels),
                      "exposed " + std::to_string(channels));
  texture.clear(0.0f, 0.0f, 0.0f, 0.0f);
  return texture;
}

} // namespace

// In the order of the table, so that the same set always means the same program.
Exposure::Exposure(std::vector<IntermediateId> watched, const gl::Rect& region)
    : watched_(inTableOrder(std::move(watched))), region_(region) {
  one_ = makeLayers(watched_, region, 1);
  two_ = makeLayers(watched_, region, 2);
  four_ = makeLayers(watched_, region, 4);
}

std::size_t exposureBytes(const std::vector<IntermediateId>& watched, const gl::Rect& region) {
  std::size_t sum = 0;
  for (IntermediateId id : watched)
    sum += gl::textureBytes({region.width, region.height}, formatOf(storedChannels(id)));
  return sum;
}

bool Exposure::holds(IntermediateId id) const {
  return std::ranges::binary_search(watched_, id);
}

const gl::Texture& Exposure::texture(IntermediateId id) const {
  assert(holds(id));
  const int channels = storedChannels(id);
  return channels == 1 ? one_ : channels == 2 ? two_ : four_;
}

int Exposure::layer(IntermediateId id) const {
  assert(holds(id));
  const auto self = std::ranges::lower_bound(watched_, id);
  return static_cast<int>(std::count_if(watched_.begin(), self, [id](IntermediateId other) {
    return storedChannels(other) == storedChannels(id);
  }));
}

Image Exposure::image(IntermediateId id) const {
  Image stored = texture(id).download(layer(id));
  if (intermediate(id).channels == stored.channels) return stored;
  Image image(stored.width, stored.height, intermediate(id).channels);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) std::copy_n(stored.at(x, y), image.channels, image.at(x, y));
  return image;
}

} // namespace taa
