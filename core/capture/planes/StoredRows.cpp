#include "core/capture/planes/StoredRows.h"

#include "core/base/Half.h"
#include "core/capture/planes/PlaneFiles.h"

#include <cstdint>
#include <cstring>

namespace taa::capture {

namespace {

template <typename T>
T loadFrom(const std::byte* at) {
  T value;
  std::memcpy(&value, at, sizeof(T));
  return value;
}

/// `value(at)` for each pixel of a row, `step` bytes apart.
template <typename Out, typename Value>
void unpack(const std::byte* at, std::size_t step, std::size_t width, Out* out, std::size_t outStep,
            const Value& value) {
  for (std::size_t x = 0; x < width; ++x, at += step, out += outStep) *out = value(at);
}

void unpackFloats(OIIO::TypeDesc::BASETYPE type, const std::byte* at, std::size_t step, std::size_t width,
                  float* out, std::size_t outStep) {
  const auto each = [&](const auto& value) { unpack(at, step, width, out, outStep, value); };
  using Byte = const std::byte*;
  switch (type) {
  case OIIO::TypeDesc::HALF:
    each([](Byte p) { return floatOfHalf(loadFrom<std::uint16_t>(p)); });
    return;
  case OIIO::TypeDesc::FLOAT:
    each([](Byte p) { return loadFrom<float>(p); });
    return;
  case OIIO::TypeDesc::DOUBLE:
    each([](Byte p) { return static_cast<float>(loadFrom<double>(p)); });
    return;
  case OIIO::TypeDesc::UINT8:
    each([](Byte p) { return static_cast<float>(loadFrom<std::uint8_t>(p)) / 255.0f; });
    return;
  case OIIO::TypeDesc::UINT16:
    each([](Byte p) { return static_cast<float>(loadFrom<std::uint16_t>(p)) / 65535.0f; });
    return;
  default:
    each([](Byte p) { return static_cast<float>(loadFrom<std::uint32_t>(p)); });
    return;
  }
}

void unpackIds(OIIO::TypeDesc::BASETYPE type, const std::byte* at, std::size_t step, std::size_t width,
               std::uint32_t* out) {
  const auto each = [&](const auto& value) { unpack(at, step, width, out, 1, value); };
  using Byte = const std::byte*;
  switch (type) {
  case OIIO::TypeDesc::UINT8:
    each([](Byte p) { return loadFrom<std::uint8_t>(p); });
    return;
  case OIIO::TypeDesc::UINT16:
    each([](Byte p) { return loadFrom<std::uint16_t>(p); });
    return;
  case OIIO::TypeDesc::UINT32:
    each([](Byte p) { return loadFrom<std::uint32_t>(p); });
    return;
  case OIIO::TypeDesc::HALF:
    each([](Byte p) { return idOf(floatOfHalf(loadFrom<std::uint16_t>(p))); });
    return;
  case OIIO::TypeDesc::FLOAT:
    each([](Byte p) { return idOf(loadFrom<float>(p)); });
    return;
  default:
    each([](Byte p) { return idOf(static_cast<float>(loadFrom<double>(p))); });
    return;
  }
}

} // namespace

void unpackRow(PlaneData& plane, int row, const std::byte* at, std::size_t pixelBytes,
               const std::vector<StoredChannel>& channels) {
  const auto width = static_cast<std::size_t>(plane.width);
  const std::size_t first = static_cast<std::size_t>(row) * width;
  if (!plane.integers.empty()) {
    unpackIds(channels[0].type, at + channels[0].offset, pixelBytes, width, plane.integers.data() + first);
    return;
  }
  float* out = plane.image.pixels.data() + first * channels.size();
  for (const StoredChannel& channel : channels)
    unpackFloats(channel.type, at + channel.offset, pixelBytes, width, out++, channels.size());
}

} // namespace taa::capture
