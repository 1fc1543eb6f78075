// Whether the parts of a glTF file fit together: data inside buffers, nodes in trees, channels with samplers.
#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/base/json/JsonFields.h"
#include "core/scene/gltf/GltfDocument.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace taa {

namespace {

constexpr std::uint64_t kMaxElements = 1u << 25;                  ///< of an accessor
constexpr std::uint64_t kMaxComponents = 1u << 27;                ///< of them: 512 MiB as floats
constexpr std::uint64_t kMaxBufferBytes = std::uint64_t(1) << 31; ///< of all buffers together

constexpr std::uint64_t kMaxImageBytes = std::uint64_t(1) << 30; ///< of all images together, as files

std::string listPlace(std::string_view list, std::size_t index) {
  return elementOf(std::string(list), index) + ": ";
}

/// The list `name`, empty when it is absent.
const Json& arrayOf(const Json& object, const char* name) {
  static const Json kEmpty = Json::array();
  const auto found = object.find(name);
  return found == object.end() ? kEmpty : *found;
}

std::uint64_t countOf(const Json& object, const char* name) {
  return object.value(name, std::uint64_t(0));
}

/// Bytes in a base64 data URI of a kind tinygltf decodes. Throws Error when it is not one.
std::uint64_t dataUriBytes(const std::string& uri) {
  constexpr std::array<std::string_view, 5> kPrefixes{
      "data:application/octet-stream;base64,", "data:application/gltf-buffer;base64,",
      "data:text/plain;base64,", "data:image/png;base64,", "data:image/jpeg;base64,"};
  std::string_view data(uri);
  const auto prefix = std::ranges::find_if(
      kPrefixes, [&](std::string_view candidate) { return data.starts_with(candidate); });
  if (prefix == kPrefixes.end()) throw Error(say<"its data URI is not base64 of a buffer, PNG or JPEG">());
  data.remove_prefix(prefix->size());
  const std::size_t end = std::min(data.find('='), data.size());
  const auto isBase64 = [](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '+' || c == '/';
  };
  if (!std::all_of(data.begin(), data.begin() + static_cast<std::ptrdiff_t>(end), isBase64) ||
      data.find_first_not_of('=', end) != std::string_view::npos || end % 4 == 1)
    throw Error(say<"its data URI is not valid base64">());
  return end / 4 * 3 + (end % 4 == 0 ? 0 : end % 4 - 1);
}

/// How many bytes the buffer really has.
std::uint64_t bufferBytes(GltfDocument& document, Json& buffer, std::size_t index) {
  const auto uri = buffer.find("uri");
  if (uri == buffer.end()) {
    if (!document.isBinary || index != 0)
      throw Error(say<"it has no uri and there is no binary chunk for it">());
    return document.binary.size();
  }
  const std::string text = uri->get<std::string>();
  return text.starts_with("data:") ? dataUriBytes(text) : takeGltfFile(document, *uri);
}

void checkBuffers(GltfDocument& document) {
  if (!document.json.contains("buffers")) return;
  Json& buffers = document.json["buffers"];
  std::uint64_t total = 0;
  for (std::size_t i = 0; i < buffers.size(); ++i) try {
      const std::uint64_t declared = countOf(buffers[i], "byteLength"),
                          there = bufferBytes(document, buffers[i], i);
      if (there < declared)
        throw Error(say<"%1 is %2 where there are %3 bytes">("byteLength", declared, there));
      total += there;
      if (total > kMaxBufferBytes) throw Error(say<"the buffers have more than %1 bytes">(kMaxBufferBytes));
      buffers[i]["byteLength"] = there; // may be longer by padding; tinygltf wants it exact
    } catch (const Error& error) {
      throw Error(listPlace("buffers", i) + error.what());
    }
}

void checkViews(const Json& root) {
  const Json& views = arrayOf(root, "bufferViews");
  for (std::size_t i = 0; i < views.size(); ++i) {
    const Json& view = views[i];
    const std::uint64_t offset = countOf(view, "byteOffset"), length = countOf(view, "byteLength");
    const std::uint64_t holds =
        root["buffers"][view["buffer"].get<std::size_t>()]["byteLength"].get<std::uint64_t>();
    if (offset + length > holds)
      throw Error(
          listPlace("bufferViews", i) +
          say<"%1 bytes from byte %2 on reach past the %3 bytes of its buffer">(length, offset, holds));
    const std::uint64_t stride = countOf(view, "byteStride");
    if (stride != 0 && (stride < 4 || stride > 252 || stride % 4 != 0))
      throw Error(listPlace("bufferViews", i) + say<"%1 %2 is none of 4, 8, … 252">("byteStride", stride));
  }
}

std::uint64_t componentBytes(const Json& object) {
  switch (object["componentType"].get<int>()) {
  case 5120:
  case 5121:
    return 1;
  case 5122:
  case 5123:
    return 2;
  case 5125:
  case 5126:
    return 4;
  default:
    throw Error(say<"%1 does not exist">("componentType " + object["componentType"].dump()));
  }
}

std::uint64_t elementBytes(const Json& accessor) {
  constexpr std::array<std::pair<std::string_view, std::uint64_t>, 7> kTypes{
      {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}}};
  const std::string type = accessor["type"].get<std::string>();
  const auto found = std::ranges::find(kTypes, type, &std::pair<std::string_view, std::uint64_t>::first);
  if (found == kTypes.end()) throw Error(say<"%1 does not exist">("type \"" + shownText(type) + "\""));
  return found->second * componentBytes(accessor);
}

/// `count` elements of `bytes` bytes in what `reference` (bufferView, byteOffset) points at.
void checkSpan(const Json& root, const Json& reference, std::uint64_t count, std::uint64_t bytes) {
  const Json& view = root["bufferViews"][reference["bufferView"].get<std::size_t>()];
  const std::uint64_t stride = std::max(countOf(view, "byteStride"), bytes),
                      holds = countOf(view, "byteLength");
  const std::uint64_t end = countOf(reference, "byteOffset") + stride * (count - 1) + bytes;
  if (end > holds)
    throw Error(
        say<"%1 elements of %2 bytes need %3 bytes; its %4 has %5">(count, bytes, end, "bufferView", holds));
}

void checkAccessor(const Json& root, const Json& accessor) {
  const std::uint64_t count = countOf(accessor, "count"), bytes = elementBytes(accessor);
  const std::uint64_t most = std::min(kMaxElements, kMaxComponents * componentBytes(accessor) / bytes);
  if (count > most) throw Error(say<"%1 %2 is more than the %3 that can be opened">("count", count, most));
  if (accessor.contains("bufferView")) checkSpan(root, accessor, count, bytes);
  if (!accessor.contains("sparse")) return;
  const Json& sparse = accessor["sparse"];
  const std::uint64_t changed = countOf(sparse, "count");
  if (changed > count) throw Error("sparse: " + say<"%1 elements of %2">(changed, count));
  checkSpan(root, sparse["indices"], changed, componentBytes(sparse["indices"]));
  checkSpan(root, sparse["values"], changed, bytes);
}

void checkAccessors(const Json& root) {
  const Json& accessors = arrayOf(root, "accessors");
  for (std::size_t i = 0; i < accessors.size(); ++i) try {
      checkAccessor(root, accessors[i]);
    } catch (const Error& error) {
      throw Error(listPlace("accessors", i) + error.what());
    }
  const Json& meshes = arrayOf(root, "meshes");
  for (std::size_t i = 0; i < meshes.size(); ++i)
    for (const Json& primitive : meshes[i]["primitives"])
      if (primitive.contains("indices") &&
          !accessors[primitive["indices"].get<std::size_t>()].contains("bufferView"))
        throw Error(listPlace("meshes", i) + say<"the accessor of its indices has no %1">("bufferView"));
}

/// How many bytes the image's own file or data URI has; 0 for one in a buffer.
std::uint64_t imageBytes(GltfDocument& document, Json& image) {
  const auto uri = image.find("uri");
  if ((uri == image.end()) != image.contains("bufferView"))
    throw Error(say<"it must have either a uri or a bufferView">());
  if (uri == image.end()) return 0;
  const std::string text = uri->get<std::string>();
  const std::uint64_t bytes = text.starts_with("data:") ? dataUriBytes(text) : takeGltfFile(document, *uri);
  if (bytes == 0) throw Error(say<"it is empty">());
  return bytes;
}

void findImageFaults(GltfDocument& document) {
  const auto images = document.json.find("images");
  if (images == document.json.end()) return;
  document.imageFaults.resize(images->size());
  std::uint64_t total = 0;
  for (std::size_t i = 0; i < images->size(); ++i) try {
      const std::uint64_t bytes = imageBytes(document, (*images)[i]);
      if (total + bytes > kMaxImageBytes)
        throw Error(say<"with it the images have more than %1 bytes">(kMaxImageBytes));
      total += bytes;
    } catch (const std::exception& error) { // ours, or the file system's
      document.imageFaults[i] = shownReason(error);
      Json& image = (*images)[i]; // tinygltf refuses a file for such an image, and would read it
      image.erase("bufferView");
      image["uri"] = "data:image/png;base64,AAAA";
    }
}

/// Throws Error when a node has two parents or the way up never ends.
void checkTrees(const Json& nodes) {
  std::vector<int> parents(nodes.size(), -1);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (const Json& child : arrayOf(nodes[i], "children")) {
      int& parent = parents[child.get<std::size_t>()];
      if (parent >= 0)
        throw Error(listPlace("nodes", child.get<std::size_t>()) +
                    say<"it is a child of both nodes[%1] and nodes[%2]">(parent, i));
      parent = static_cast<int>(i);
    }
  std::vector<int> walk(nodes.size(), -1); // the walk up, named by its start, that has passed a node
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (int at = static_cast<int>(i); at >= 0; at = parents[static_cast<std::size_t>(at)]) {
      int& passed = walk[static_cast<std::size_t>(at)];
      if (passed == static_cast<int>(i))
        throw Error(listPlace("nodes", static_cast<std::size_t>(at)) +
                    say<"it is its own ancestor: the nodes form a cycle">());
      if (passed >= 0) break; // an earlier walk found the end from here
      passed = static_cast<int>(i);
    }
}

void checkScenes(const Json& root) {
  const Json& scenes = arrayOf(root, "scenes");
  // The last scene that names a node.
  std::vector<std::size_t> listed(arrayOf(root, "nodes").size(), scenes.size());
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    for (const Json& node : arrayOf(scenes[i], "nodes")) {
      const std::size_t index = node.get<std::size_t>();
      if (listed[index] == i) throw Error(listPlace("scenes", i) + say<"it lists nodes[%1] twice">(index));
      listed[index] = i;
    }
  }
}

void checkAnimations(const Json& root) {
  const Json& animations = arrayOf(root, "animations");
  for (std::size_t i = 0; i < animations.size(); ++i)
    for (const Json& channel : animations[i]["channels"])
      if (channel["sampler"].get<std::uint64_t>() >= animations[i]["samplers"].size())
        throw Error(listPlace("animations", i) +
                    say<"a channel asks for samplers[%1]; there are %2">(channel["sampler"].dump(),
                                                                         animations[i]["samplers"].size()));
}

/// Of each camera: what its type names has to be there.
void checkCameras(const Json& root) {
  const Json& cameras = arrayOf(root, "cameras");
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    const auto type = cameras[i]["type"].get<std::string>();
    const std::string place = elementOf("cameras", i) + ".";
    if (type != "perspective" && type != "orthographic")
      throw Error(place + "type: " + say<"\"%1\" is neither perspective nor orthographic">(shownText(type)));
    if (!cameras[i].contains(type)) throw Error(place + type + ": " + say<"missing">());
  }
}

void checkLights(const Json& root) {
  const Json::json_pointer list("/extensions/KHR_lights_punctual/lights");
  if (!root.contains(list)) return;
  const Json& lights = root[list];
  for (std::size_t i = 0; i < lights.size(); ++i)
    if (lights[i]["type"] == "spot" && !lights[i].contains("spot"))
      throw Error(listPlace("extensions.KHR_lights_punctual.lights", i) +
                  say<"it is a spot without \"spot\"">());
}

/// Removes extras and unknown extensions at every level.
void stripLevel(Json& value) {
  if (value.is_object()) {
    value.erase("extras");
    if (const auto extensions = value.find("extensions");
        extensions != value.end() && extensions->is_object())
      for (auto extension = extensions->begin(); extension != extensions->end();)
        extension =
            isKnownGltfExtension(extension.key()) ? std::next(extension) : extensions->erase(extension);
  }
  if (value.is_structured())
    for (Json& part : value) stripLevel(part);
}

} // namespace

void checkGltfData(GltfDocument& document) {
  checkBuffers(document);
  checkViews(document.json);
  checkAccessors(document.json);
  findImageFaults(document);
}

void checkGltfGraph(const Json& root) {
  checkTrees(arrayOf(root, "nodes"));
  checkScenes(root);
  checkAnimations(root);
  checkCameras(root);
  checkLights(root);
}

void stripGltf(Json& root) {
  stripLevel(root);
  const auto animations = root.find("animations");
  if (animations == root.end()) return;
  for (auto& animation : *animations) { // a channel without a node is for an extension; tinygltf refuses it
    auto& channels = animation["channels"].get_ref<Json::array_t&>();
    std::erase_if(channels, [](const Json& channel) { return !channel["target"].contains("node"); });
  }
}

} // namespace taa
