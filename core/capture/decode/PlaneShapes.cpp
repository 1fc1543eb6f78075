#include "core/capture/decode/PlaneShapes.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/capture/decode/Nearest.h"
#include "core/scene/ObjectClass.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace taa::capture {

namespace {

/// What stands in channels that a plane has not.
float fillOf(PlaneKind kind) {
  const bool isAlpha = kind == PlaneKind::Color || kind == PlaneKind::Output || kind == PlaneKind::Reference;
  return isAlpha ? 1.0f : 0.0f;
}

/// As many as its kind has; see channelsOf().
Image withAllChannels(Image&& image, PlaneKind kind) {
  const int wanted = channelsOf(kind);
  if (image.channels == wanted) return std::move(image);
  const float fill = fillOf(kind);
  Image result(image.width, image.height, wanted);
  const int copied = std::min(image.channels, wanted);
  const float* from = image.pixels.data();
  float* to = result.pixels.data();
  const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  for (std::size_t i = 0; i < pixels; ++i, from += image.channels, to += wanted)
    for (int channel = 0; channel < wanted; ++channel) to[channel] = channel < copied ? from[channel] : fill;
  return result;
}

} // namespace

PlaneShapes::PlaneShapes(FramePlanes& planes, const glm::ivec2& sizePx, int frame)
    : planes_(planes), sizePx_(sizePx), frame_(frame) {}

PlaneData* PlaneShapes::find(PlaneKind kind) {
  const auto found = planes_.find(kind);
  if (found == planes_.end()) return nullptr;
  PlaneData& plane = found->second;
  const bool isId = kind == PlaneKind::ObjectId;
  const int channels = isId ? 1 : plane.image.channels;
  const bool hasSize = plane.width > 0 && plane.height > 0 && channels > 0;
  const std::size_t values = isId ? plane.integers.size() : plane.image.pixels.size();
  const bool isWhole = hasSize && values == static_cast<std::size_t>(plane.width) *
                                                static_cast<std::size_t>(plane.height) *
                                                static_cast<std::size_t>(channels);
  const bool isSame = isId || (plane.image.width == plane.width && plane.image.height == plane.height);
  if (!isWhole || !isSame)
    throw Error(say<"frame %1: %2 does not have as many values as its size says">(frame_, planeName(kind)));
  if (const int needed = minChannelsOf(kind); channels < needed)
    throw Error(say<"frame %1: %2 has %3 channels, and %4 are needed; set its channels in capture.json">(
        frame_, planeName(kind), channels, needed));
  return &plane;
}

void PlaneShapes::note(PlaneKind kind, const PlaneData& plane) {
  notes_.push_back(say<"%1 is %2×%3 and the frame %4×%5: each pixel takes the nearest value">(
      planeName(kind), plane.width, plane.height, sizePx_.x, sizePx_.y));
}

Image PlaneShapes::takeUnscaled(PlaneKind kind) {
  PlaneData* plane = find(kind);
  return plane ? withAllChannels(std::move(plane->image), kind) : Image();
}

Image PlaneShapes::take(PlaneKind kind) {
  const PlaneData* plane = find(kind);
  if (!plane) return {};
  const glm::ivec2 size(plane->width, plane->height);
  if (size != sizePx_) note(kind, *plane);
  Image image = takeUnscaled(kind);
  if (size == sizePx_) return image;
  image.pixels = resized(image.pixels, size, sizePx_, static_cast<std::size_t>(image.channels));
  image.width = sizePx_.x;
  image.height = sizePx_.y;
  return image;
}

Image PlaneShapes::takeNormals() {
  const PlaneData* plane = find(PlaneKind::Normal);
  const bool hasClasses = plane && plane->image.channels == 4;
  Image normals = take(PlaneKind::Normal);
  if (!hasClasses) return normals;
  const auto isClass = [](float value) {
    return value >= 0.0f && value < static_cast<float>(kObjectClasses.size()) && std::trunc(value) == value;
  };
  std::vector<float>& values = normals.pixels;
  std::size_t at = 3;
  while (at < values.size() && isClass(values[at])) at += 4;
  if (at >= values.size()) return normals;
  notes_.push_back(say<"the fourth channel of %1 is %2 somewhere, which is no class of an object: no classes "
                       "are taken from it">(planeName(PlaneKind::Normal), std::to_string(values[at])));
  for (at = 3; at < values.size(); at += 4) values[at] = 0.0f;
  return normals;
}

std::vector<std::uint32_t> PlaneShapes::takeIds() {
  PlaneData* plane = find(PlaneKind::ObjectId);
  if (!plane) return {};
  const glm::ivec2 size(plane->width, plane->height);
  if (size == sizePx_) return std::move(plane->integers);
  note(PlaneKind::ObjectId, *plane);
  return resized(plane->integers, size, sizePx_, 1);
}

} // namespace taa::capture
