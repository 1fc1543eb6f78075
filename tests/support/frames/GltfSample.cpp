#include "tests/support/frames/GltfSample.h"

#include "core/base/Files.h"
#include "tests/support/Paths.h"

#include <cstdint>

namespace taa::test {

namespace {

using nlohmann::json;

constexpr const char* kRedPixel =
    "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8BQ"
    "DwAEhQGAhKmMIQAAAABJRU5ErkJggg==";

json emptyGltf() {
  return json::parse(R"({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 4]}],
    "nodes": [{"name": "root", "children": [1, 2, 3], "scale": [1, -1, 1]}, {"name": "triangle", "mesh": 0},
              {"name": "eye", "camera": 0, "extensions": {"KHR_lights_punctual": {"light": 0}}},
              {"name": "joint", "translation": [0, 2, 0], "rotation": [0, 0, 0, 1]}, {"name": "skinned", "mesh": 0, "skin": 0}],
    "extensionsUsed": ["KHR_lights_punctual"],
    "extensions": {"KHR_lights_punctual": {"lights": [{"type": "spot", "intensity": 5, "color": [1, 0.5, 0], "spot": {"outerConeAngle": 0.5}}]}},
    "cameras": [{"type": "perspective", "perspective": {"yfov": 0.9, "znear": 0.1, "zfar": 10}}],
    "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "texCoord": 0}, "metallicFactor": 0.25},
                   "normalTexture": {"index": 0, "scale": 2}, "alphaMode": "MASK", "alphaCutoff": 0.25}],
    "textures": [{"source": 0, "sampler": 0}], "samplers": [{"magFilter": 9728, "wrapS": 33071}],
    "buffers": [{}], "bufferViews": [], "accessors": []
  })");
}

void addMesh(GltfSample& sample) {
  json attributes;
  attributes["POSITION"] = sample.addFloats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  attributes["TEXCOORD_0"] = sample.addFloats({0, 1, 1, 1, 0, 0}, "VEC2");
  attributes["WEIGHTS_0"] = sample.addFloats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
  const std::uint8_t joints[12] = {};
  attributes["JOINTS_0"] = sample.json["accessors"].size();
  sample.json["accessors"].push_back(
      {{"bufferView", sample.addView(joints, 12)}, {"componentType", 5121}, {"count", 3}, {"type", "VEC4"}});
  const std::uint16_t indices[3] = {0, 1, 2};
  const std::size_t order = sample.json["accessors"].size();
  sample.json["accessors"].push_back({{"bufferView", sample.addView(indices, 6)},
                                      {"componentType", 5123},
                                      {"count", 3},
                                      {"type", "SCALAR"}});
  sample.json["meshes"] = {
      {{"primitives", {{{"attributes", attributes}, {"indices", order}, {"material", 0}}}}}};
}

} // namespace

GltfSample::GltfSample() : json(emptyGltf()) {
  json["images"] = {{{"uri", kRedPixel}, {"name", "red"}}};
  addMesh(*this);
  const int binds = addFloats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, "MAT4");
  json["skins"] = {{{"joints", {3}}, {"inverseBindMatrices", binds}}};
  const int times = addFloats({0, 1}, "SCALAR"), places = addFloats({0, 0, 0, 0, 4, 0}, "VEC3");
  json["animations"] = {
      {{"samplers", {{{"input", times}, {"output", places}}}},
       {"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}}}}}};
}

int GltfSample::addView(const void* data, std::size_t bytes) {
  const std::size_t offset = buffer.size();
  buffer.append(static_cast<const char*>(data), bytes);
  buffer.resize((buffer.size() + 3) / 4 * 4, '\0');
  json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes}});
  json["buffers"][0]["byteLength"] = buffer.size();
  return static_cast<int>(json["bufferViews"].size()) - 1;
}

int GltfSample::addFloats(const std::vector<float>& values, const std::string& type) {
  const std::size_t components = type == "SCALAR" ? 1
                                 : type == "MAT4" ? 16
                                                  : static_cast<std::size_t>(type[3] - '0');
  const int view = addView(values.data(), values.size() * sizeof(float));
  json["accessors"].push_back(
      {{"bufferView", view}, {"componentType", 5126}, {"count", values.size() / components}, {"type", type}});
  return static_cast<int>(json["accessors"].size()) - 1;
}

std::filesystem::path GltfSample::writeEmbedded(const std::string& name) const {
  nlohmann::json whole = json;
  whole["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(buffer);
  return writeTemporary(name + ".gltf", whole.dump());
}

std::filesystem::path GltfSample::writeBinary(const std::string& name) const {
  return writeTemporary(name + ".glb", joinGlb(json.dump(), buffer));
}

GltfSample morphSample(const char* interpolation, const std::vector<float>& weights) {
  GltfSample sample;
  nlohmann::json& mesh = sample.json["meshes"][0];
  mesh["primitives"][0]["targets"] = {{{"POSITION", sample.addFloats({0, 0, 0, 0, 0, 2, 0, 0, 0}, "VEC3")}}};
  mesh["weights"] = {0.5};
  nlohmann::json& animation = sample.json["animations"][0];
  animation["samplers"].push_back({{"input", sample.addFloats({0, 1}, "SCALAR")},
                                   {"output", sample.addFloats(weights, "SCALAR")},
                                   {"interpolation", interpolation}});
  const int last = static_cast<int>(animation["samplers"].size()) - 1;
  animation["channels"].push_back({{"sampler", last}, {"target", {{"node", 1}, {"path", "weights"}}}});
  return sample;
}

std::string joinGlb(std::string json, std::string binary) {
  const auto word = [](std::size_t value) {
    const auto narrow = static_cast<std::uint32_t>(value);
    return std::string(reinterpret_cast<const char*>(&narrow), 4);
  };
  json.resize((json.size() + 3) / 4 * 4, ' ');
  binary.resize((binary.size() + 3) / 4 * 4, '\0');
  return "glTF" + word(2) + word(28 + json.size() + binary.size()) + word(json.size()) + "JSON" + json +
         word(binary.size()) + std::string("BIN\0", 4) + binary;
}

std::string base64(const std::string& bytes) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * k) & 63];
  }
  return text;
}

std::filesystem::path writeTemporary(const std::string& name, const std::string& bytes) {
  std::filesystem::path path = temporaryFolder() / name;
  std::filesystem::create_directories(path.parent_path());
  writeFile(path, bytes);
  return path;
}

} // namespace taa::test
