#include "core/scene/gltf/GltfImage.h"

#include "core/base/Error.h"
#include "core/base/Say.h"

#include <tiny_gltf.h>
#include <zlib.h>

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

bool isPng(Bytes bytes) {
  constexpr std::array<unsigned char, 8> kPng{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  return startsWith(bytes, kPng);
}

/// The picture's size from its header, before anything is allocated for it.
Size sizeOf(Bytes bytes) {
  constexpr std::array<unsigned char, 3> kJpeg{0xFF, 0xD8, 0xFF};
  if (isPng(bytes))
    return bytes.size() < 24 ? Size{} : Size{bigEndian(bytes, 16, 4), bigEndian(bytes, 20, 4)};
  if (startsWith(bytes, kJpeg)) return jpegSize(bytes);
  throw Error(say<"it is neither PNG nor JPEG">());
}

/// How much unpacked data of a PNG has room in its picture, with what interlacing adds to small ones.
std::size_t mostUnpacked(Bytes bytes, const Size& size) {
  const std::size_t depth = std::min<std::size_t>(bytes[24], 16);
  const std::size_t bits = depth * (bytes[25] == 2 ? 3 : bytes[25] == 6 ? 4 : 2);
  constexpr std::size_t kInterlaced = 4096;
  return 2 * size.height * (1 + (size.width * bits + 7) / 8) + kInterlaced;
}

/// Unpacks and counts, keeping nothing.
class Unpacked {
 public:
  Unpacked() {
    if (inflateInit(&stream_) != Z_OK) throw Error(say<"there is not enough memory to unpack its picture">());
  }
  Unpacked(const Unpacked&) = delete;
  Unpacked& operator=(const Unpacked&) = delete;
  ~Unpacked() { inflateEnd(&stream_); }

  /// The bytes so far; no more are read once they are above `most`. What is damaged ends it.
  std::size_t add(Bytes packed, std::size_t most) {
    stream_.next_in = const_cast<unsigned char*>(packed.data()); // zlib only reads it
    stream_.avail_in = static_cast<uInt>(packed.size());
    while (stream_.avail_in > 0 && stream_.total_out <= most) {
      stream_.next_out = buffer_.data();
      stream_.avail_out = static_cast<uInt>(buffer_.size());
      if (inflate(&stream_, Z_NO_FLUSH) != Z_OK) break;
    }
    return stream_.total_out;
  }

 private:
  z_stream stream_{};
  std::array<unsigned char, 1 << 15> buffer_;
};

/// The decoder takes as much memory as a part of a PNG says that it has, and as its data unpack to.
void checkPng(Bytes bytes, const Size& size) {
  constexpr std::array<unsigned char, 4> kData{'I', 'D', 'A', 'T'}, kEnd{'I', 'E', 'N', 'D'};
  constexpr std::size_t kAround = 12; ///< of a part: its length, its name and its checksum
  constexpr std::size_t kHead = 26;   ///< all that is known of its pixels
  if (bytes.size() < kHead) return;
  const std::size_t most = mostUnpacked(bytes, size);
  Unpacked unpacked;
  std::size_t at = 8;
  while (at + kAround <= bytes.size()) {
    const std::size_t length = bigEndian(bytes, at, 4);
    if (length > bytes.size() - at - kAround)
      throw Error(say<"its picture is damaged: a part of it ends behind its end">());
    const Bytes name = bytes.subspan(at + 4, 4);
    if (startsWith(name, kEnd)) return;
    if (startsWith(name, kData) && unpacked.add(bytes.subspan(at + 8, length), most) > most)
      throw Error(
          say<"its picture is damaged: it unpacks to more than its %1×%2 pixels">(size.width, size.height));
    at += kAround + length;
  }
}

} // namespace

SceneImage decodeImage(Bytes bytes) {
  const Size size = sizeOf(bytes);
  if (size.width == 0 || size.height == 0) throw Error(say<"its picture is damaged: it has no size">());
  if (size.width > kMaxImageSide || size.height > kMaxImageSide || size.width * size.height > kMaxImagePixels)
    throw Error(say<"its picture of %1×%2 pixels is too large">(size.width, size.height));
  if (isPng(bytes)) checkPng(bytes, size);
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
