#include "core/scene/gltf/GltfImport.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/scene/gltf/GltfDocument.h"

#include <tiny_gltf.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace taa {

namespace {

/// Keeps the file of the picture; it is decoded when a material asks for it.
bool keepEncoded(tinygltf::Image* image, int /*index*/, std::string* /*error*/, std::string* /*warning*/,
                 int /*width*/, int /*height*/, const unsigned char* bytes, int size, void* /*user*/) {
  image->image.assign(bytes, bytes + size);
  return true;
}

void append(std::string& bytes, std::uint32_t value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// A .glb around the checked JSON.
std::string joinBinary(std::string json, const std::string& binary) {
  constexpr std::uint32_t kMagic = 0x46546C67, kJson = 0x4E4F534A, kBinary = 0x004E4942;
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::size_t padded = (binary.size() + 3) / 4 * 4;
  const std::size_t length = 12 + 8 + json.size() + (padded > 0 ? 8 + padded : 0);
  std::string bytes;
  bytes.reserve(length);
  for (const std::uint32_t value : {kMagic, std::uint32_t(2), static_cast<std::uint32_t>(length),
                                    static_cast<std::uint32_t>(json.size()), kJson})
    append(bytes, value);
  bytes += json;
  if (padded > 0) {
    append(bytes, static_cast<std::uint32_t>(padded));
    append(bytes, kBinary);
    bytes += binary;
    bytes.resize(length, '\0');
  }
  return bytes;
}

std::string firstLine(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

} // namespace

void importGltf(const GltfDocument& document, tinygltf::Model& model) {
  tinygltf::TinyGLTF parser;
  parser.SetImageLoader(keepEncoded, nullptr);
  std::string json = document.json.dump(), error, warning;
  const std::string folder = document.folder.string();
  bool good = false;
  if (document.isBinary) {
    const std::string bytes = joinBinary(std::move(json), document.binary);
    good = parser.LoadBinaryFromMemory(&model, &error, &warning,
                                       reinterpret_cast<const unsigned char*>(bytes.data()),
                                       static_cast<unsigned>(bytes.size()), folder);
  } else {
    good = parser.LoadASCIIFromString(&model, &error, &warning, json.data(),
                                      static_cast<unsigned>(json.size()), folder);
  }
  if (!good) throw Error("tinygltf: " + (error.empty() ? say<"it cannot be read">() : firstLine(error)));
}

} // namespace taa
