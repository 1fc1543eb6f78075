// The planes of one captured frame as they lie in files, not yet in this program's conventions.
#pragma once

#include "core/base/Image.h"
#include "core/capture/format/Manifest.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <vector>

namespace taa::capture {

/// Pixels of one plane: 8192 × 8192.
inline constexpr std::size_t kMaxPlanePixels = std::size_t(1) << 26;

/// Values as stored (normalized formats as 0 to 1, sRGB formats not decoded but where the format's name says
/// SRGB), row 0 at the top whatever the file's order is. Channels: those stored or named, of its kind at most
/// channelsOf(), at least minChannelsOf().
struct PlaneData {
  Image image; ///< floats: everything but ids
  /// PlaneKind::ObjectId only, width · height of them; `image` has no pixels then.
  std::vector<std::uint32_t> integers;
  int width = 0, height = 0;
  bool hasEightBits = false; ///< of a picture: a channel is stored in 256 steps
};
using FramePlanes = std::map<PlaneKind, PlaneData>;

/// Reads one plane. Throws Error that names file, plane and reason: missing, truncated, damaged, of another
/// size than stated, without the channels, too large, Y/C; in bounded time and memory. Thread-safe.
PlaneData readPlane(const std::filesystem::path& folder, const Manifest& manifest, const CapturedFrame& frame,
                    PlaneKind kind);
/// All planes that the frame has, on two threads; those of one picture are read together. Throws Error.
FramePlanes readPlanes(const std::filesystem::path& folder, const Manifest& manifest,
                       const CapturedFrame& frame);
/// As above on this thread alone. `proceed` is called before each file; what it throws goes on.
FramePlanes readPlanesInTurn(const std::filesystem::path& folder, const Manifest& manifest,
                             const CapturedFrame& frame, const std::function<void()>& proceed);

/// Writes a raw plane file of `format`, rows from the top, whole or not at all. Values are rounded to the
/// nearest, those of integer and normalized formats clamped; channels that `format` has and the plane has not
/// are 0, alpha 1. Ids go into integer formats alone and have to fit. Throws Error.
void writeRawPlane(const std::filesystem::path& file, const PlaneData& plane, RawFormat format);

} // namespace taa::capture
