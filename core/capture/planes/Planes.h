// The planes of one captured frame as they lie in files, not yet in this program's conventions.
#pragma once

#include "core/base/Image.h"
#include "core/capture/format/Manifest.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <vector>

namespace taa::capture {

/// Values as stored (normalized formats as 0 to 1, sRGB formats not decoded but where the format's name says
/// SRGB), row 0 at the top whatever the file's order is.
struct PlaneData {
  Image image; ///< floats: everything but ids
  std::vector<std::uint32_t>
      integers; ///< PlaneKind::ObjectId only, width · height of `image`, whose pixels are empty then
  int width = 0, height = 0;
};
using FramePlanes = std::map<PlaneKind, PlaneData>;

/// Reads one plane. Throws Error that names file, plane and reason: missing, truncated, damaged, of another
/// size than stated, without the channels, too large, Y/C; in bounded time and memory. Thread-safe.
PlaneData readPlane(const std::filesystem::path& folder, const Manifest& manifest, const CapturedFrame& frame,
                    PlaneKind kind);
/// All planes that the frame has. Throws Error.
FramePlanes readPlanes(const std::filesystem::path& folder, const Manifest& manifest,
                       const CapturedFrame& frame);

/// Writes a raw plane file of `format`, rows from the top, whole or not at all. Throws Error.
void writeRawPlane(const std::filesystem::path& file, const PlaneData& plane, RawFormat format);
std::size_t bytesPerPixel(RawFormat format);
int rawChannels(RawFormat format);

} // namespace taa::capture
