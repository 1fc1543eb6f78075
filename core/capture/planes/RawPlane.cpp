// Raw planes: files that hold what lay in an engine's memory, read row by row, and written.
#include "core/base/Files.h"
#include "core/base/Say.h"
#include "core/capture/planes/PlaneFiles.h"
#include "core/capture/planes/RawFormats.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace taa::capture {

namespace {

constexpr std::size_t kBlockBytes = std::size_t(512) << 10; ///< stays in the cache until it is decoded

/// How the rows of a file lie.
struct RawLayout {
  RawFormat format = RawFormat::RGBA16F;
  glm::ivec2 sizePx{0};
  std::uintmax_t rowBytes = 0, pitch = 0;

  std::uintmax_t minBytes() const { return pitch * static_cast<std::uintmax_t>(sizePx.y - 1) + rowBytes; }
  std::uintmax_t maxBytes() const { return pitch * static_cast<std::uintmax_t>(sizePx.y); }
  std::string text() const {
    return std::to_string(sizePx.x) + " × " + std::to_string(sizePx.y) + " " +
           std::string(rawFormatName(format));
  }
};

RawLayout layoutOf(const Manifest& manifest, const PlaneRequest& request) {
  const glm::ivec2 stated = request.source->sizePx;
  RawLayout layout{*request.source->raw, stated.x > 0 ? stated : manifest.sizeOf(request.kind), 0, 0};
  requireSize(manifest, request, layout.sizePx);
  layout.rowBytes = bytesPerPixel(layout.format) * static_cast<std::uintmax_t>(layout.sizePx.x);
  layout.pitch = request.source->rowPitch == 0 ? layout.rowBytes : request.source->rowPitch;
  if (layout.pitch < layout.rowBytes)
    throw Error(say<"a row pitch of %1 bytes is less than the %2 that a row of %3 takes">(
        layout.pitch, layout.rowBytes, layout.text()));
  if (layout.pitch > std::numeric_limits<std::uintmax_t>::max() / (2 * kMaxCaptureSide))
    throw Error(say<"a row pitch of %1 bytes is not one">(layout.pitch));
  return layout;
}

void requireFileSize(const UntrustedFile& file, const std::string& name, const RawLayout& layout) {
  if (file.size() < layout.minBytes())
    throw Error(say<"%1 has %2 bytes; %3 at a row pitch of %4 takes %5">(name, file.size(), layout.text(),
                                                                         layout.pitch, layout.minBytes()));
  if (file.size() > layout.maxBytes())
    throw Error(
        say<"%1 has %2 bytes, more than the %3 of %4 at a row pitch of %5: size or format is another">(
            name, file.size(), layout.maxBytes(), layout.text(), layout.pitch));
}

void decodeInto(PlaneData& plane, const RawLayout& layout, int row, const std::byte* bytes) {
  const auto width = static_cast<std::size_t>(plane.width);
  const std::size_t first = static_cast<std::size_t>(row) * width;
  if (plane.integers.empty()) {
    const auto channels = static_cast<std::size_t>(plane.image.channels);
    decodeRow(layout.format, bytes, plane.image.channels,
              std::span(plane.image.pixels).subspan(first * channels, width * channels));
    return;
  }
  const std::span<std::uint32_t> ids = std::span(plane.integers).subspan(first, width);
  if (isInteger(layout.format)) {
    decodeIds(layout.format, bytes, ids);
    return;
  }
  std::vector<float> stored(width);
  decodeRow(layout.format, bytes, 1, stored);
  std::ranges::transform(stored, ids.begin(), idOf);
}

/// As many rows at once as fit a block, one where the file holds more than its rows.
void readRawRows(const UntrustedFile& file, const RawLayout& layout, bool bottomFirst, PlaneData& plane) {
  const bool isDense = layout.pitch <= 2 * layout.rowBytes;
  const int rowsAtOnce =
      isDense ? static_cast<int>(std::clamp<std::uintmax_t>(kBlockBytes / layout.pitch, 1, plane.height)) : 1;
  std::vector<std::byte> block(
      static_cast<std::size_t>(layout.pitch * static_cast<unsigned>(rowsAtOnce - 1) + layout.rowBytes));
  for (int first = 0; first < plane.height; first += rowsAtOnce) {
    const int count = std::min(rowsAtOnce, plane.height - first);
    const auto bytes =
        static_cast<std::size_t>(layout.pitch * static_cast<unsigned>(count - 1) + layout.rowBytes);
    file.read(layout.pitch * static_cast<unsigned>(first), std::span(block).first(bytes));
    for (int i = 0; i < count; ++i) {
      const int row = bottomFirst ? plane.height - 1 - (first + i) : first + i;
      decodeInto(plane, layout, row, block.data() + layout.pitch * static_cast<unsigned>(i));
    }
  }
}

} // namespace

PlaneData readRawPlane(const std::filesystem::path& folder, const Manifest& manifest,
                       const PlaneRequest& request) {
  const RawLayout layout = layoutOf(manifest, request);
  const int stored = rawChannels(layout.format);
  if (stored < minChannelsOf(request.kind))
    throw Error(say<"%1 has %2 channels; %3 are needed">(rawFormatName(layout.format), stored,
                                                         minChannelsOf(request.kind)));
  const UntrustedFile file = openUntrusted(folder, request.file, std::numeric_limits<std::uintmax_t>::max());
  requireFileSize(file, request.file, layout);
  PlaneData plane = makePlane(request.kind, layout.sizePx, std::min(stored, channelsOf(request.kind)));
  readRawRows(file, layout, request.bottomFirst, plane);
  return plane;
}

void writeRawPlane(const std::filesystem::path& file, const PlaneData& plane, RawFormat format) {
  const auto width = static_cast<std::size_t>(plane.width);
  const std::size_t rowBytes = width * bytesPerPixel(format);
  const bool holdsIds = !plane.integers.empty();
  assert(plane.width > 0 && plane.height > 0);
  assert(!holdsIds || plane.integers.size() == width * static_cast<std::size_t>(plane.height));
  assert(holdsIds || (plane.image.width == plane.width && plane.image.height == plane.height));
  if (holdsIds) {
    if (!isInteger(format))
      throw Error(say<"cannot write %1: ids are stored as integers, not as %2">(file.string(),
                                                                                rawFormatName(format)));
    const std::uint32_t largest = *std::ranges::max_element(plane.integers);
    if (bytesPerPixel(format) < 4 && largest >> (8u * bytesPerPixel(format)) != 0)
      throw Error(
          say<"cannot write %1: id %2 does not fit into %3">(file.string(), largest, rawFormatName(format)));
  }
  std::string bytes(rowBytes * static_cast<std::size_t>(plane.height), '\0');
  auto* at = reinterpret_cast<std::byte*>(bytes.data());
  for (int row = 0; row < plane.height; ++row, at += rowBytes) {
    const std::size_t first = static_cast<std::size_t>(row) * width;
    if (holdsIds) {
      encodeIds(format, std::span(plane.integers).subspan(first, width), at);
      continue;
    }
    const auto channels = static_cast<std::size_t>(plane.image.channels);
    encodeRow(format, std::span(plane.image.pixels).subspan(first * channels, width * channels),
              plane.image.channels, at);
  }
  writeFile(file, bytes);
}

} // namespace taa::capture
