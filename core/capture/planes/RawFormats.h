// Rows of raw planes: bits as engines and drivers lay them out, and the values they stand for.
#pragma once

#include "core/capture/format/Manifest.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace taa::capture {

/// Whether its values are whole numbers as they are, up to 32 bits.
bool isInteger(RawFormat format);

/// Values of the pixels that lie at `row`, out.size() / channels of them, the first `channels` of each.
void decodeRow(RawFormat format, const std::byte* row, int channels, std::span<float> out);
/// The first channel of the pixels that lie at `row`, for integer formats.
void decodeIds(RawFormat format, const std::byte* row, std::span<std::uint32_t> out);

/// Pixels of `channels` values each. Channels beyond them are 0, alpha 1; values are rounded to the nearest.
void encodeRow(RawFormat format, std::span<const float> values, int channels, std::byte* row);
/// For integer formats; ids have to fit.
void encodeIds(RawFormat format, std::span<const std::uint32_t> ids, std::byte* row);

} // namespace taa::capture
