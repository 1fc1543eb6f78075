#include "core/scene/gltf/GltfDocument.h"

#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/base/OldNames.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/base/json/LimitedJson.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <string_view>
#include <system_error>
#include <utility>

namespace taa {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kMaxFileBytes = std::uintmax_t(1) << 30;
/// What walks the JSON afterwards is recursive. Buffers may be texts within it.
constexpr JsonLimits kGltfLimits{.bytes = std::size_t(1) << 28, .depth = 64, .memory = std::size_t(1) << 29};

constexpr std::array<std::string_view, 6> kExtensions{
    "EXT_mesh_gpu_instancing", "KHR_lights_punctual",   "KHR_materials_emissive_strength",
    "KHR_materials_unlit",     "KHR_mesh_quantization", "KHR_texture_transform"};

constexpr std::string_view kGlbMagic = "glTF";
constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

std::uint32_t word(const std::string& bytes, std::size_t offset) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + offset, sizeof value); // both glTF and our machines are little-endian
  return value;
}

/// The two chunks of a .glb.
struct Chunks {
  std::string json, binary;
};

Chunks splitBinary(const std::string& bytes) {
  constexpr std::size_t kHeader = 12, kChunkHeader = 8;
  if (bytes.size() < kHeader) throw Error(say<"header: the file ends after %1 bytes">(bytes.size()));
  const std::uint32_t version = word(bytes, 4), length = word(bytes, 8);
  if (version != 2)
    throw Error(say<"header: it is binary glTF %1; only glTF 2.0 can be opened, export it anew">(version));
  if (length > bytes.size())
    throw Error(say<"header: the file has %1 bytes where it says %2">(bytes.size(), length));
  Chunks chunks;
  int index = 0;
  for (std::size_t at = kHeader; at + kChunkHeader <= length; ++index) {
    const std::size_t size = word(bytes, at);
    const std::uint32_t type = word(bytes, at + 4);
    if (size > length - at - kChunkHeader)
      throw Error(say<"chunk %1: its %2 bytes reach past the end of the file">(index, size));
    if ((index == 0) != (type == kJsonChunk))
      throw Error(say<"chunk %1: the first chunk, and only that, must be JSON">(index));
    if (index == 0) chunks.json = bytes.substr(at + kChunkHeader, size);
    if (index == 1 && type == kBinaryChunk) chunks.binary = bytes.substr(at + kChunkHeader, size);
    at += kChunkHeader + size;
  }
  if (index == 0) throw Error(say<"header: there is no chunk with JSON">());
  return chunks;
}

Json parseGltf(const std::string& text) {
  try {
    return parseLimited(text, kGltfLimits);
  } catch (const Error& error) {
    throw Error(std::string("JSON: ") + error.what());
  }
}

struct GltfVersion {
  int major = 0, minor = 0;
};

/// Of "2.0". Throws Error where it is none.
GltfVersion versionFrom(const Json& asset, const char* key) {
  const std::string place = std::string("asset.") + key + ": ";
  const auto found = asset.find(key);
  if (found == asset.end() || !found->is_string()) throw Error(place + say<"missing or not a text">());
  const std::string text = found->get<std::string>();
  const char* const end = text.data() + text.size();
  GltfVersion version;
  const auto [dot, majorError] = std::from_chars(text.data(), end, version.major);
  if (majorError == std::errc() && dot != end && *dot == '.') {
    const auto [rest, minorError] = std::from_chars(dot + 1, end, version.minor);
    if (minorError == std::errc() && rest == end && version.major >= 0 && version.minor >= 0) return version;
  }
  throw Error(place + say<"\"%1\" is not a version such as 2.0">(shownText(text)));
}

void checkVersion(const Json& root) {
  if (!root.is_object()) throw Error(say<"JSON: the file holds no object">());
  const auto asset = root.find("asset");
  const bool isOld = asset == root.end() &&
                     (root.contains("techniques") || (root.contains("nodes") && root["nodes"].is_object()));
  if (isOld)
    throw Error("asset: " + say<"it is glTF %1; only glTF 2.0 can be opened, export it anew">("1.0"));
  if (asset == root.end()) throw Error("asset: " + say<"missing; it is not a glTF file">());
  if (!asset->is_object()) throw Error("asset: " + say<"not an object">());
  const GltfVersion version = versionFrom(*asset, "version");
  if (version.major != 2)
    throw Error("asset.version: " + say<"it is glTF %1; only glTF 2.0 can be opened, export it anew">(
                                        std::to_string(version.major) + "." + std::to_string(version.minor)));
  if (!asset->contains("minVersion")) return; // a later 2.x is said to be readable as 2.0
  const GltfVersion least = versionFrom(*asset, "minVersion");
  if (least.major != 2 || least.minor != 0)
    throw Error("asset.minVersion: " +
                say<"it needs glTF %1; only glTF 2.0 can be opened, export it for that">(
                    std::to_string(least.major) + "." + std::to_string(least.minor)));
}

void checkExtensions(const Json& root) {
  const auto required = root.find("extensionsRequired");
  if (required == root.end()) return;
  if (!required->is_array()) throw Error("extensionsRequired: " + say<"not a list">());
  for (const Json& name : *required) {
    if (!name.is_string()) throw Error("extensionsRequired: " + say<"not a list of texts">());
    if (!isKnownGltfExtension(name.get<std::string>()))
      throw Error("extensionsRequired: " +
                  say<"it needs the extension %1, which is not supported; export it without">(
                      shownText(name.get<std::string>())));
  }
}

std::string percentDecoded(const std::string& uri) {
  std::string text;
  const auto digit = [](char c) {
    return c >= '0' && c <= '9' ? c - '0' : (c | 32) >= 'a' && (c | 32) <= 'f' ? (c | 32) - 'a' + 10 : -1;
  };
  for (std::size_t i = 0; i < uri.size(); ++i)
    if (uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) >= 0 && digit(uri[i + 2]) >= 0) {
      text += static_cast<char>(16 * digit(uri[i + 1]) + digit(uri[i + 2]));
      i += 2;
    } else {
      text += uri[i];
    }
  return text;
}

} // namespace

bool isKnownGltfExtension(const std::string& name) {
  return std::ranges::find(kExtensions, name) != kExtensions.end();
}

std::string readGltfFile(const fs::path& file, std::uintmax_t maxBytes) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status)) throw Error(say<"there is no such file">());
  if (fs::is_directory(status)) throw Error(say<"it is a folder">());
  if (!fs::is_regular_file(status)) throw Error(say<"it is not a regular file">());
  try {
    return readFile(file, maxBytes);
  } catch (const Error& failure) { // "cannot read FILE: reason"
    const std::string text = failure.what();
    const std::size_t at = text.find(file.string() + ": ");
    throw Error(at == std::string::npos ? text : text.substr(at + file.string().size() + 2));
  }
}

std::uint64_t takeGltfFile(GltfDocument& document, Json& uri) {
  std::string name = percentDecoded(uri.get<std::string>());
  if (name.find('\\') != std::string::npos) {
    std::ranges::replace(name, '\\', '/');
    addNotes(document.notes, {say<"Backslashes in the names of its files are taken for slashes.">()});
  }
  const bool hasScheme = name.find(':') != std::string::npos; // http:, file:, C:
  const fs::path path(name);
  if (name.empty() || hasScheme || name.find('\0') != std::string::npos || path.is_absolute() ||
      std::ranges::find(path, fs::path("..")) != path.end())
    throw Error(say<"\"%1\" is not a file below the folder of the scene; only such files are opened">(
        shownText(name)));
  std::error_code error;
  if (!fs::exists(document.folder / path, error))
    throw Error(say<"there is no file \"%1\" beside it">(shownText(name)));
  document.files.push_back({name, requireRegularBelow(document.folder, path)});
  uri = std::to_string(document.files.size() - 1);
  return fs::file_size(document.files.back().path);
}

GltfDocument readGltfDocument(const fs::path& file) {
  std::string bytes = readGltfFile(file, kMaxFileBytes);
  GltfDocument document;
  document.folder = file.has_parent_path() ? file.parent_path() : ".";
  if (bytes.starts_with(kGlbMagic)) {
    Chunks chunks = splitBinary(bytes);
    document.isBinary = true;
    document.binary = std::move(chunks.binary);
    bytes = std::move(chunks.json);
  }
  document.json = parseGltf(bytes);
  checkVersion(document.json);
  checkExtensions(document.json);
  return document;
}

} // namespace taa
