#include "core/scene/gltf/GltfImport.h"

#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/scene/gltf/GltfDocument.h"

#include <tiny_gltf.h>

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace taa {

namespace {

/// Keeps the file of the picture; it is decoded when a material asks for it.
bool keepEncoded(tinygltf::Image* image, int /*index*/, std::string* /*error*/, std::string* /*warning*/,
                 int /*width*/, int /*height*/, const unsigned char* bytes, int size, void* /*user*/) {
  image->image.assign(bytes, bytes + size);
  return true;
}

/// Of a uri that takeGltfFile() has numbered; null: there is none.
const GltfFile* numberedFile(const std::string& uri, const void* document) {
  const std::vector<GltfFile>& files = static_cast<const GltfDocument*>(document)->files;
  std::size_t index = files.size();
  const char* const end = uri.data() + uri.size();
  const auto [rest, error] = std::from_chars(uri.data(), end, index);
  return error == std::errc() && rest == end && index < files.size() ? &files[index] : nullptr;
}

constexpr std::uintmax_t kMaxNamedBytes = std::uintmax_t(1) << 31;

/// tinygltf 2.9 also asks how large a file is; readFile() refuses what is too large anyway.
template <typename Callbacks>
void addFileSize(Callbacks& callbacks) {
  if constexpr (requires { callbacks.GetFileSizeInBytes; })
    callbacks.GetFileSizeInBytes = [](std::size_t* bytes, std::string*, const std::string& uri, void* user) {
      std::error_code error;
      *bytes = std::filesystem::file_size(numberedFile(uri, user)->path, error);
      return !error;
    };
}

/// tinygltf opens files by no other way than this. All are set: from 2.9 on it takes its own for all where
/// one is not.
tinygltf::FsCallbacks fileAccess(const GltfDocument& document) {
  tinygltf::FsCallbacks callbacks{};
  callbacks.FileExists = [](const std::string& uri, void* user) {
    return numberedFile(uri, user) != nullptr;
  };
  callbacks.ExpandFilePath = [](const std::string& uri, void*) { return uri; };
  callbacks.ReadWholeFile = [](std::vector<unsigned char>* out, std::string* error, const std::string& uri,
                               void* user) {
    try {
      const std::string bytes = readFile(numberedFile(uri, user)->path, kMaxNamedBytes);
      out->assign(bytes.begin(), bytes.end());
      return true;
    } catch (const std::exception& failure) {
      *error = shownReason(failure);
      return false;
    }
  };
  callbacks.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
    return false; // nothing is written
  };
  addFileSize(callbacks);
  callbacks.user_data = const_cast<GltfDocument*>(&document);
  return callbacks;
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

/// A list of the file, and bytes of tinygltf's struct for each of its entries: an empty one has three
/// letters.
struct ListedBytes {
  const char* list;
  std::size_t bytes;
};
constexpr ListedBytes kListedBytes[] = {{"accessors", sizeof(tinygltf::Accessor)},
                                        {"animations", sizeof(tinygltf::Animation)},
                                        {"bufferViews", sizeof(tinygltf::BufferView)},
                                        {"buffers", sizeof(tinygltf::Buffer)},
                                        {"cameras", sizeof(tinygltf::Camera)},
                                        {"images", sizeof(tinygltf::Image)},
                                        {"materials", sizeof(tinygltf::Material)},
                                        {"meshes", sizeof(tinygltf::Mesh)},
                                        {"nodes", sizeof(tinygltf::Node)},
                                        {"samplers", sizeof(tinygltf::Sampler)},
                                        {"scenes", sizeof(tinygltf::Scene)},
                                        {"skins", sizeof(tinygltf::Skin)},
                                        {"textures", sizeof(tinygltf::Texture)}};
constexpr std::size_t kMaxListedBytes = std::size_t(512) << 20;

/// Throws Error that names the list with which it is too much.
void checkListedBytes(const Json& root) {
  std::size_t sum = 0;
  for (const ListedBytes& each : kListedBytes) {
    const auto list = root.find(each.list);
    if (list == root.end()) continue;
    sum += list->size() * each.bytes;
    if (sum > kMaxListedBytes)
      throw Error(std::string(each.list) + ": " +
                  say<"with these %1 the lists of the file take more than %2 MiB of memory">(
                      list->size(), kMaxListedBytes >> 20));
  }
}

std::string firstLine(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

} // namespace

void importGltf(const GltfDocument& document, tinygltf::Model& model) {
  checkListedBytes(document.json);
  tinygltf::TinyGLTF parser;
  parser.SetImageLoader(keepEncoded, nullptr);
  parser.SetFsCallbacks(fileAccess(document));
  std::string json = document.json.dump(), error, warning;
  bool good = false;
  if (document.isBinary) {
    const std::string bytes = joinBinary(std::move(json), document.binary);
    good = parser.LoadBinaryFromMemory(&model, &error, &warning,
                                       reinterpret_cast<const unsigned char*>(bytes.data()),
                                       static_cast<unsigned>(bytes.size()), "");
  } else {
    good = parser.LoadASCIIFromString(&model, &error, &warning, json.data(),
                                      static_cast<unsigned>(json.size()), "");
  }
  for (tinygltf::Image& image : model.images)
    if (const GltfFile* file = numberedFile(image.uri, &document)) image.uri = file->name;
  if (!good) throw Error("tinygltf: " + (error.empty() ? say<"it cannot be read">() : firstLine(error)));
}

} // namespace taa
