#include "core/capture/format/Manifest.h"

#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/base/Say.h"
#include "core/base/json/LimitedJson.h"
#include "core/capture/format/ManifestKeys.h"

#include <algorithm>
#include <iterator>

namespace taa::capture {

namespace fs = std::filesystem;

namespace {

struct PlaneInfo {
  std::string_view name;
  int least, most; ///< channels
  std::string_view description;
};

/// By PlaneKind.
constexpr PlaneInfo kPlanes[] = {
    {"color", 3, 4, "Red, green, blue before TAA, with the frame's jitter."},
    {"motion", 2, 2, "x and y of motion."},
    {"depth", 1, 1, "Depth."},
    {"objectId", 1, 1, "The whole number of the object that is seen; 0: nothing."},
    {"normal", 3, 4,
     "x, y, z in world space; fourth, of a raw plane or a channel that is named, the number of the object's "
     "class, 0 to 4; where any is none of these, all are taken as not known."},
    {"previousDepth", 1, 1,
     "The distance along the camera's axis that the surface had in the previous frame, in meters; 0: none."},
    {"mask", 1, 2,
     "What TAA should trust history less for, 0 to 1: what was blended in (reactive); second, where known, "
     "what changes without motion (responsive)."},
    {"overlay", 4, 4,
     "Red, green, blue, alpha, premultiplied, without jitter: what is laid over the output."},
    {"fog", 3, 4, "Light that fog scatters to the camera; fourth: what it takes of the surface's."},
    {"output", 3, 4, "Red, green, blue of what the engine's own TAA made of the frame."},
    {"reference", 3, 4, "Red, green, blue of a picture to compare with, supersampled."},
};
static_assert(std::size(kPlanes) == kPlaneKinds);

struct RawFormatInfo {
  std::string_view name;
  std::uint8_t channels, bytes; ///< of a pixel
};

/// By RawFormat.
constexpr RawFormatInfo kRawFormatInfos[] = {
    {"R11G11B10F", 3, 4}, {"RGBA16F", 4, 8},    {"RGBA32F", 4, 16},    {"RG16F", 2, 4},
    {"RG32F", 2, 8},      {"RG16_UNORM", 2, 4}, {"RGBA8_UNORM", 4, 4}, {"RGBA8_SRGB", 4, 4},
    {"R16F", 1, 2},       {"R32F", 1, 4},       {"D32F", 1, 4},        {"D24S8", 1, 4},
    {"D32F_S8", 1, 8},    {"R16_UNORM", 1, 2},  {"R8_UNORM", 1, 1},    {"RG8_UNORM", 2, 2},
    {"R8_UINT", 1, 1},    {"R16_UINT", 1, 2},   {"R32_UINT", 1, 4},    {"D24S8_GL", 1, 4},
};
static_assert(std::size(kRawFormatInfos) == kRawFormats);

const PlaneInfo& infoOf(PlaneKind kind) {
  return kPlanes[static_cast<std::size_t>(kind)];
}

const RawFormatInfo& infoOf(RawFormat format) {
  return kRawFormatInfos[static_cast<std::size_t>(format)];
}

} // namespace

std::string_view planeName(PlaneKind kind) {
  return infoOf(kind).name;
}

std::optional<PlaneKind> planeOf(std::string_view name) {
  const auto found = std::ranges::find(kPlanes, name, &PlaneInfo::name);
  if (found == std::end(kPlanes)) return {};
  return static_cast<PlaneKind>(found - std::begin(kPlanes));
}

std::string_view planeDescription(PlaneKind kind) {
  return infoOf(kind).description;
}

int channelsOf(PlaneKind kind) {
  return infoOf(kind).most;
}

int minChannelsOf(PlaneKind kind) {
  return infoOf(kind).least;
}

std::string_view rawFormatName(RawFormat format) {
  return infoOf(format).name;
}

int rawChannels(RawFormat format) {
  return infoOf(format).channels;
}

std::size_t bytesPerPixel(RawFormat format) {
  return infoOf(format).bytes;
}

std::optional<RawFormat> rawFormatOf(std::string_view name) {
  const auto found = std::ranges::find(kRawFormatInfos, name, &RawFormatInfo::name);
  if (found == std::end(kRawFormatInfos)) return {};
  return static_cast<RawFormat>(found - std::begin(kRawFormatInfos));
}

std::string rawFormatNames() {
  std::string names;
  for (const RawFormatInfo& info : kRawFormatInfos)
    names += (names.empty() ? "" : ", ") + std::string(info.name);
  return names;
}

std::string planeFile(const PlaneSource& source, int frameNumber) {
  constexpr std::string_view kBegin = "{frame";
  std::string file;
  std::string_view rest = source.file;
  for (std::size_t begin; (begin = rest.find(kBegin)) != std::string_view::npos;) {
    file += rest.substr(0, begin);
    rest.remove_prefix(begin + kBegin.size());
    std::string digits = std::to_string(frameNumber);
    if (rest.starts_with(':')) {
      const auto width = static_cast<std::size_t>(rest.size() > 1 ? rest[1] - '0' : 0);
      if (width <= 9 && digits.size() < width) digits.insert(0, width - digits.size(), '0');
      rest.remove_prefix(std::min<std::size_t>(2, rest.size()));
    }
    rest.remove_prefix(rest.empty() ? 0 : 1); // the closing brace
    file += digits;
  }
  return file += rest;
}

const PlaneSource* Manifest::plane(const CapturedFrame& frame, PlaneKind kind) const {
  if (const auto own = frame.planes.find(kind); own != frame.planes.end()) return &own->second;
  const auto found = planes.find(kind);
  return found == planes.end() ? nullptr : &found->second;
}

std::size_t Manifest::framesWith(PlaneKind kind) const {
  return static_cast<std::size_t>(std::ranges::count_if(
      frames, [&](const CapturedFrame& frame) { return plane(frame, kind) != nullptr; }));
}

Manifest readManifest(const fs::path& folder, const std::string& name) {
  std::string text;
  try {
    const UntrustedFile file = openUntrusted(folder, name, kMaxJsonBytes);
    text.resize(static_cast<std::size_t>(file.size()));
    file.read(0, {reinterpret_cast<std::byte*>(text.data()), text.size()});
  } catch (const Error& error) {
    throw Error(say<"cannot open the capture %1: %2">(folder.string(), error.what()));
  }
  return parseManifest(text, (folder / name).string());
}

} // namespace taa::capture
