#include "core/scene/gltf/GltfImage.h"

#include "core/base/Error.h"
#include "core/base/Say.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace taa {

namespace {

using Bytes = std::span<const unsigned char>;

constexpr int kMaxImageSide = 16384; ///< pixels; what every GL 4.5 driver holds
constexpr std::size_t kMaxImagePixels = std::size_t(1) << 26;

struct Size {
  std::size_t width = 0, height = 0;
};

std::size_t bigEndian(Bytes bytes, std::size_t at, std::size_t count) {
  std::size_t value = 0;
  for (std::size_t i = 0; i < count; ++i) value = value << 8 | bytes[at + i];
  return value;
}

bool startsWith(Bytes bytes, std::span<const unsigned char> prefix) {
  return bytes.size() >= prefix.size() && std::equal(prefix.begin(), prefix.end(), bytes.begin());
}

/// The size in the first frame header; 0 when there is none.
Size jpegSize(Bytes bytes) {
  std::size_t at = 2;
  while (at + 9 < bytes.size() && bytes[at] == 0xFF) {
    const unsigned char marker = bytes[at + 1];
    const bool isFrame =
        marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
    if (isFrame) return {bigEndian(bytes, at + 7, 2), bigEndian(bytes, at + 5, 2)};
    at += marker == 0xFF ? 1 : 2 + bigEndian(bytes, at + 2, 2);
  }
  return {};
}

/// The picture's size from its header, before anything is allocated for it.
Size sizeOf(Bytes bytes) {
  constexpr std::array<unsigned char, 8> kPng{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  constexpr std::array<unsigned char, 3> kJpeg{0xFF, 0xD8, 0xFF};
  if (startsWith(bytes, kPng))
    return bytes.size() < 24 ? Size{} : Size{bigEndian(bytes, 16, 4), bigEndian(bytes, 20, 4)};
  if (startsWith(bytes, kJpeg)) return jpegSize(bytes);
  throw Error(say<"it is neither PNG nor JPEG">());
}

} // namespace

SceneImage decodeImage(Bytes bytes) {
  const Size size = sizeOf(bytes);
  if (size.width == 0 || size.height == 0) throw Error(say<"its picture is damaged: it has no size">());
  if (size.width > kMaxImageSide || size.height > kMaxImageSide || size.width * size.height > kMaxImagePixels)
    throw Error(say<"its picture of %1×%2 pixels is too large">(size.width, size.height));
  tinygltf::Image decoded;
  std::string error, warning;
  if (!tinygltf::LoadImageData(&decoded, 0, &error, &warning, 0, 0, bytes.data(),
                               static_cast<int>(bytes.size()), nullptr) ||
      decoded.width <= 0 || decoded.height <= 0 || decoded.component != 4)
    throw Error(say<"its picture is damaged and cannot be decoded">());
  SceneImage image;
  image.width = decoded.width;
  image.height = decoded.height;
  if (decoded.bits == 16) { // the high byte of each little-endian pair
    for (std::size_t i = 1; i < decoded.image.size(); i += 2) image.rgba.push_back(decoded.image[i]);
  } else {
    image.rgba = std::move(decoded.image);
  }
  return image;
}

} // namespace taa
