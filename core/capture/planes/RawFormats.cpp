#include "core/capture/planes/RawFormats.h"

#include "core/base/Half.h"
#include "core/base/Light.h"
#include "core/capture/planes/Planes.h"
#include "core/capture/planes/SmallFloats.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>

namespace taa::capture {

namespace {

static_assert(std::endian::native == std::endian::little, "raw planes are little-endian");

/// What the values of a pixel are: components of one kind, or packed into words.
enum class Layout : std::uint8_t {
  Half,
  Float,
  Unorm8,
  Srgb8,
  Unorm16,
  Uint8,
  Uint16,
  Uint32,
  PackedFloats,
  DepthLow24,
  DepthHigh24,
  FloatOfEight,
};

/// By RawFormat.
constexpr Layout kLayouts[] = {
    Layout::PackedFloats, // R11G11B10F
    Layout::Half,         // RGBA16F
    Layout::Float,        // RGBA32F
    Layout::Half,         // RG16F
    Layout::Float,        // RG32F
    Layout::Unorm16,      // RG16_UNORM
    Layout::Unorm8,       // RGBA8_UNORM
    Layout::Srgb8,        // RGBA8_SRGB
    Layout::Half,         // R16F
    Layout::Float,        // R32F
    Layout::Float,        // D32F
    Layout::DepthLow24,   // D24S8
    Layout::FloatOfEight, // D32F_S8
    Layout::Unorm16,      // R16_UNORM
    Layout::Unorm8,       // R8_UNORM
    Layout::Unorm8,       // RG8_UNORM
    Layout::Uint8,        // R8_UINT
    Layout::Uint16,       // R16_UINT
    Layout::Uint32,       // R32_UINT
    Layout::DepthHigh24,  // D24S8_GL
};
static_assert(std::size(kLayouts) == kRawFormats);

Layout layoutOf(RawFormat format) {
  return kLayouts[static_cast<std::size_t>(format)];
}

template <typename T>
T load(const std::byte* at) {
  T value;
  std::memcpy(&value, at, sizeof(T));
  return value;
}

template <typename T>
void store(std::byte* at, T value) {
  std::memcpy(at, &value, sizeof(T));
}

const std::array<float, 256>& srgbTable() {
  static const std::array<float, 256> kTable = [] {
    std::array<float, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i)
      table[i] = static_cast<float>(srgbDecoded(static_cast<double>(i) / 255.0));
    return table;
  }();
  return kTable;
}

/// Calls `value(stored, channel)` for the first `channels` of the `stride` components of each pixel.
template <typename Stored, typename Value>
void decodeComponents(const std::byte* row, int stride, int channels, std::span<float> out,
                      const Value& value) {
  if (stride == channels) {
    // Blocks of a size that the compiler knows become vectors at any level of optimization.
    constexpr std::size_t kBlock = 16;
    std::size_t i = 0;
    for (; i + kBlock <= out.size(); i += kBlock) {
      std::array<Stored, kBlock> stored;
      std::array<float, kBlock> values;
      std::memcpy(stored.data(), row + i * sizeof(Stored), sizeof(stored));
      for (std::size_t k = 0; k < kBlock; ++k) values[k] = value(stored[k]);
      std::memcpy(out.data() + i, values.data(), sizeof(values));
    }
    for (; i < out.size(); ++i) out[i] = value(load<Stored>(row + i * sizeof(Stored)));
    return;
  }
  const std::size_t kept = static_cast<std::size_t>(channels);
  for (std::size_t i = 0; i < out.size(); i += kept, row += sizeof(Stored) * stride)
    for (std::size_t channel = 0; channel < kept; ++channel)
      out[i + channel] = value(load<Stored>(row + channel * sizeof(Stored)));
}

void decodeSrgb(const std::byte* row, int channels, std::span<float> out) {
  const std::array<float, 256>& table = srgbTable();
  const std::size_t kept = static_cast<std::size_t>(channels);
  for (std::size_t i = 0; i < out.size(); i += kept, row += 4)
    for (std::size_t channel = 0; channel < kept; ++channel) {
      const auto stored = static_cast<std::uint8_t>(row[channel]);
      out[i + channel] = channel < 3 ? table[stored] : static_cast<float>(stored) / 255.0f;
    }
}

void decodePackedFloats(const std::byte* row, int channels, std::span<float> out) {
  // As halves first, in blocks: that loop becomes vectors.
  constexpr std::size_t kBlock = 16;
  const std::size_t kept = static_cast<std::size_t>(channels);
  const std::size_t pixels = out.size() / kept;
  for (std::size_t first = 0; first < pixels; first += kBlock) {
    const std::size_t count = std::min(kBlock, pixels - first);
    std::array<std::uint32_t, kBlock> bits{};
    std::array<std::array<float, kBlock>, 3> planes;
    std::memcpy(bits.data(), row + first * 4, count * 4);
    for (std::size_t k = 0; k < kBlock; ++k) planes[0][k] = floatOf11Bits(bits[k]);
    for (std::size_t k = 0; k < kBlock; ++k) planes[1][k] = floatOf11Bits(bits[k] >> 11u);
    for (std::size_t k = 0; k < kBlock; ++k) planes[2][k] = floatOf10Bits(bits[k] >> 22u);
    float* to = out.data() + first * kept;
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t channel = 0; channel < kept; ++channel) *to++ = planes[channel][k];
  }
}

/// Rounds `value`, clamped to 0…1, to a whole number of 1/`most`; NaN is 0, as Direct3D has it.
std::uint32_t unormOf(float value, double most) {
  if (!(value > 0.0f)) return 0;
  return static_cast<std::uint32_t>(std::nearbyint(std::min(static_cast<double>(value), 1.0) * most));
}

std::uint32_t integerWithin(float value, std::uint32_t most) {
  if (!(value > 0.0f)) return 0;
  return static_cast<std::uint32_t>(
      std::min(std::nearbyint(static_cast<double>(value)), static_cast<double>(most)));
}

void encodeComponent(Layout layout, float value, int channel, std::byte* at) {
  switch (layout) {
  case Layout::Half:
    store(at, halfOf(value));
    return;
  case Layout::Unorm8:
    store(at, static_cast<std::uint8_t>(unormOf(value, 255.0)));
    return;
  case Layout::Unorm16:
    store(at, static_cast<std::uint16_t>(unormOf(value, 65535.0)));
    return;
  case Layout::Uint8:
    store(at, static_cast<std::uint8_t>(integerWithin(value, 0xffu)));
    return;
  case Layout::Uint16:
    store(at, static_cast<std::uint16_t>(integerWithin(value, 0xffffu)));
    return;
  case Layout::Uint32:
    store(at, integerWithin(value, 0xffffffffu));
    return;
  case Layout::DepthLow24:
    store(at, unormOf(value, 16777215.0));
    return;
  case Layout::DepthHigh24:
    store(at, unormOf(value, 16777215.0) << 8u);
    return;
  case Layout::FloatOfEight:
    store(at + 4, std::uint32_t{0});
    store(at, value);
    return;
  case Layout::Srgb8: {
    const float clamped = std::clamp(std::isnan(value) ? 0.0f : value, 0.0f, 1.0f);
    const double encoded = channel < 3 ? srgbEncoded(clamped) : clamped;
    store(at, static_cast<std::uint8_t>(std::nearbyint(encoded * 255.0)));
    return;
  }
  case Layout::Float:
  case Layout::PackedFloats:
    break;
  }
  store(at, value);
}

void encodePixel(RawFormat format, const float* values, std::byte* at) {
  const Layout layout = layoutOf(format);
  if (layout == Layout::PackedFloats) {
    store(at, unsignedFloatOf(values[0], 6) | unsignedFloatOf(values[1], 6) << 11u |
                  unsignedFloatOf(values[2], 5) << 22u);
    return;
  }
  const int channels = rawChannels(format);
  const int bytes = static_cast<int>(bytesPerPixel(format)) / channels;
  for (int channel = 0; channel < channels; ++channel)
    encodeComponent(layout, values[channel], channel, at + channel * bytes);
}

} // namespace

bool isInteger(RawFormat format) {
  const Layout layout = layoutOf(format);
  return layout == Layout::Uint8 || layout == Layout::Uint16 || layout == Layout::Uint32;
}

void decodeRow(RawFormat format, const std::byte* row, int channels, std::span<float> out) {
  const int stride = rawChannels(format);
  assert(channels >= 1 && channels <= stride && out.size() % static_cast<std::size_t>(channels) == 0);
  const auto decode = [&]<typename Stored>(Stored, int words, const auto& value) {
    decodeComponents<Stored>(row, words, channels, out, value);
  };
  const auto plain = [](auto stored) { return static_cast<float>(stored); };
  const std::uint32_t word = 0;
  switch (layoutOf(format)) {
  case Layout::Half:
    decode(std::uint16_t{}, stride, [](std::uint16_t v) { return floatOfHalf(v); });
    return;
  case Layout::Float:
    decode(0.0f, stride, plain);
    return;
  case Layout::Unorm8:
    decode(std::uint8_t{}, stride, [](std::uint8_t v) { return static_cast<float>(v) / 255.0f; });
    return;
  case Layout::Unorm16:
    decode(std::uint16_t{}, stride, [](std::uint16_t v) { return static_cast<float>(v) / 65535.0f; });
    return;
  case Layout::Uint8:
    decode(std::uint8_t{}, stride, plain);
    return;
  case Layout::Uint16:
    decode(std::uint16_t{}, stride, plain);
    return;
  case Layout::Uint32:
    decode(word, stride, plain);
    return;
  case Layout::DepthLow24:
    decode(word, 1, [](std::uint32_t v) {
      return static_cast<float>(static_cast<std::int32_t>(v & 0xffffffu)) / 16777215.0f;
    });
    return;
  case Layout::DepthHigh24:
    decode(word, 1, [](std::uint32_t v) {
      return static_cast<float>(static_cast<std::int32_t>(v >> 8u)) / 16777215.0f;
    });
    return;
  case Layout::FloatOfEight:
    decode(0.0f, 2, plain);
    return;
  case Layout::Srgb8:
    decodeSrgb(row, channels, out);
    return;
  case Layout::PackedFloats:
    decodePackedFloats(row, channels, out);
    return;
  }
}

void decodeIds(RawFormat format, const std::byte* row, std::span<std::uint32_t> out) {
  assert(isInteger(format));
  const std::size_t bytes = bytesPerPixel(format);
  if (bytes == sizeof(std::uint32_t)) {
    std::memcpy(out.data(), row, out.size_bytes());
    return;
  }
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = bytes == 1 ? load<std::uint8_t>(row + i) : load<std::uint16_t>(row + i * 2);
}

void encodeRow(RawFormat format, std::span<const float> values, int channels, std::byte* row) {
  const std::size_t given = static_cast<std::size_t>(channels);
  assert(channels >= 1 && values.size() % given == 0);
  const std::size_t kept = std::min(given, static_cast<std::size_t>(rawChannels(format)));
  for (std::size_t i = 0; i < values.size(); i += given, row += bytesPerPixel(format)) {
    std::array<float, 4> pixel{0.0f, 0.0f, 0.0f, 1.0f};
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(i), kept, pixel.begin());
    encodePixel(format, pixel.data(), row);
  }
}

void encodeIds(RawFormat format, std::span<const std::uint32_t> ids, std::byte* row) {
  assert(isInteger(format));
  const std::size_t bytes = bytesPerPixel(format);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    assert(bytes == 4 || ids[i] >> (8u * bytes) == 0);
    std::memcpy(row + i * bytes, &ids[i], bytes);
  }
}

} // namespace taa::capture
