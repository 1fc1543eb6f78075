// Tests of opening spoiled glTF files: the sentence for each way they can be wrong.
#include "core/base/Error.h"
#include "core/scene/builtin/SceneSource.h"
#include "tests/support/Paths.h"
#include "tests/support/frames/GltfSample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace taa {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::GltfSample;

/// The sentence a file is refused with, without "cannot open FILE: ".
std::string refusal(const fs::path& file) {
  try {
    openScene(file.string());
    return "it opened";
  } catch (const Error& error) {
    const std::string text = error.what(), start = "cannot open " + file.string() + ": ";
    EXPECT_TRUE(text.starts_with(start)) << text;
    return text.substr(std::min(text.size(), start.size()));
  }
}

std::string refusalOf(const std::function<void(GltfSample&)>& spoil) {
  GltfSample sample;
  spoil(sample);
  return refusal(sample.writeEmbedded("spoiled"));
}

/// Refusal after one JSON value was put at a JSON pointer: set("/nodes/0/mesh", 7).
std::string refusalWith(const std::string& pointer, const json& value) {
  return refusalOf([&](GltfSample& sample) { sample.json[json::json_pointer(pointer)] = value; });
}

TEST(GltfRefusal, RefusesMorphTargetsThatDoNotFit) {
  GltfSample sample;
  sample.json["meshes"][0]["primitives"][0]["targets"] = {
      {{"POSITION", sample.addFloats({0, 0, 0, 0, 0, 2}, "VEC3")}}};
  EXPECT_EQ(refusal(sample.writeEmbedded("targets")), "meshes[0].primitives[0].targets[0].POSITION: it is "
                                                      "not a finite vector of 3 for each of the 3 vertices");
  EXPECT_EQ(refusal(test::morphSample("LINEAR", {0.25f, 0.5f, 0.75f}).writeEmbedded("weights")),
            "animations[0].channels[1]: it has 3 values for 2 times");
}

// A file of some kB, which took 44 seconds to be read.
TEST(GltfRefusal, CountsTheKeysOfChannelsThatShareAnAccessor) {
  GltfSample sample;
  json& accessors = sample.json["accessors"];
  const auto zeros = [&](const char* type) { // no buffer view: all are 0
    accessors.push_back({{"componentType", 5126}, {"count", 5'000'000}, {"type", type}});
    return accessors.size() - 1;
  };
  const std::size_t times = zeros("SCALAR"), places = zeros("VEC3");
  json& animation = sample.json["animations"][0];
  animation["samplers"][0] = {{"input", times}, {"output", places}};
  const json channel = animation["channels"][0];
  for (int more = 0; more < 4; ++more) animation["channels"].push_back(channel);
  EXPECT_EQ(refusal(sample.writeEmbedded("keys")), "animations[0]: there are more than 20000000 keys");
}

TEST(GltfRefusal, SaysWhereThereAreTooManyVertices) {
  GltfSample sample;
  json& accessors = sample.json["accessors"];
  accessors.push_back({{"componentType", 5126}, {"type", "VEC3"}, {"count", 20'000'001}}); // all zero
  sample.json["meshes"][0]["primitives"][0]["attributes"] = {{"POSITION", accessors.size() - 1}};
  EXPECT_EQ(refusal(sample.writeEmbedded("vertices")),
            "meshes[0].primitives[0].attributes.POSITION: with these the scene has 20000001 vertices, more "
            "than the 20000000 that can be opened");
}

// An empty material has three letters in the file, and two thousand bytes in what is made of it.
TEST(GltfRefusal, RefusesListsThatTakeTooMuchMemory) {
  EXPECT_EQ(refusalWith("/materials", std::vector<json>(400'000, json::object())),
            "materials: with these 400000 the lists of the file take more than 512 MiB of memory");
}

TEST(GltfRefusal, IsOneShortLineWhateverTheFileSays) {
  const std::string forged = "x\ntaa-batch: all is well\x1b[2J" + std::string(5000, 'y');
  const std::string shown = "x?taa-batch: all is well?[2J" + std::string(72, 'y') + "…";
  EXPECT_EQ(refusalWith("/extensionsRequired", {forged}), "extensionsRequired: it needs the extension " +
                                                              shown +
                                                              ", which is not supported; export it without");
  EXPECT_EQ(refusalWith("/accessors/0/type", forged), "accessors[0]: type \"" + shown + "\" does not exist");
}

TEST(GltfRefusal, RefusesFilesThatAreNotThereOrNotGltf) {
  EXPECT_EQ(refusal(test::temporaryFolder() / "absent.gltf"), "there is no such file");
  EXPECT_EQ(refusal(test::temporaryFolder()), "it is a folder");
  EXPECT_EQ(refusal("/dev/zero"), "it is not a regular file");
  EXPECT_EQ(refusal(test::writeTemporary("empty.gltf", "")), "JSON: it is empty");
  EXPECT_EQ(refusal(test::writeTemporary("text.gltf", "hello")),
            "JSON: it is not JSON from line 1, column 1 on");
  EXPECT_EQ(refusal(test::writeTemporary("list.gltf", "[]")), "JSON: the file holds no object");
  EXPECT_EQ(refusal(test::writeTemporary("object.gltf", "{}")), "asset: missing; it is not a glTF file");
  EXPECT_EQ(refusal(test::writeTemporary("deep.gltf", std::string(100000, '['))),
            "JSON: it is nested deeper than 64 levels");
}

TEST(GltfRefusal, RefusesOtherVersions) {
  const std::string advice = "; only glTF 2.0 can be opened, export it anew";
  EXPECT_EQ(refusalWith("/asset/version", "1.0"), "asset.version: it is glTF 1.0" + advice);
  EXPECT_EQ(refusalWith("/asset/version", "2.7"), "it opened"); // as 2.0, which it says it is readable as
  EXPECT_EQ(refusalWith("/asset/minVersion", "2.0"), "it opened");
  for (const std::string version : {"2.1", "3.0"})
    EXPECT_EQ(refusalWith("/asset/minVersion", version),
              "asset.minVersion: it needs glTF " + version +
                  "; only glTF 2.0 can be opened, export it for that");
  EXPECT_EQ(refusalWith("/asset/version", ""), "asset.version: \"\" is not a version such as 2.0");
  EXPECT_EQ(refusalWith("/asset/version", "2.x\n"), "asset.version: \"2.x?\" is not a version such as 2.0");
  EXPECT_EQ(refusal(test::writeTemporary("old.gltf", R"({"nodes": {}, "techniques": {}})")),
            "asset: it is glTF 1.0" + advice);
  std::string glb = test::joinGlb("{}", "");
  glb[4] = 1;
  EXPECT_EQ(refusal(test::writeTemporary("old.glb", glb)), "header: it is binary glTF 1" + advice);
}

TEST(GltfRefusal, NamesARequiredExtensionThatIsMissing) {
  EXPECT_EQ(refusalWith("/extensionsRequired", {"KHR_texture_basisu"}),
            "extensionsRequired: it needs the extension KHR_texture_basisu, which is not supported; export "
            "it without");
  EXPECT_EQ(refusalWith("/extensionsRequired", 3), "extensionsRequired: not a list");
}

TEST(GltfRefusal, RefusesDamagedBinaryContainers) {
  const std::string good = test::joinGlb(GltfSample().json.dump(), GltfSample().buffer);
  const auto refused = [](const std::string& bytes) {
    return refusal(test::writeTemporary("damaged.glb", bytes));
  };
  EXPECT_EQ(refused(good.substr(0, 10)), "header: the file ends after 10 bytes");
  EXPECT_TRUE(refused(good.substr(0, good.size() - 4)).starts_with("header: the file has "));
  std::string wrong = good;
  wrong[15] = 0x7F;
  EXPECT_TRUE(refused(wrong).starts_with("chunk 0: its ")) << refused(wrong);
  wrong = good;
  wrong[16] = 'X';
  EXPECT_EQ(refused(wrong), "chunk 0: the first chunk, and only that, must be JSON");
  EXPECT_EQ(refused(std::string("glTF\2\0\0\0\14\0\0\0", 12)), "header: there is no chunk with JSON");
}

TEST(GltfRefusal, RefusesIndicesOutOfRange) {
  EXPECT_EQ(refusalWith("/scene", 1), "scene: there is no scenes[1]; there are 1");
  EXPECT_EQ(refusalWith("/scenes/0/nodes/0", 9), "scenes[0].nodes[0]: there is no nodes[9]; there are 5");
  EXPECT_EQ(refusalWith("/nodes/0/children/1", 77),
            "nodes[0].children[1]: there is no nodes[77]; there are 5");
  EXPECT_EQ(refusalWith("/nodes/1/mesh", 1), "nodes[1].mesh: there is no meshes[1]; there are 1");
  EXPECT_EQ(refusalWith("/nodes/2/camera", 1), "nodes[2].camera: there is no cameras[1]; there are 1");
  EXPECT_EQ(refusalWith("/nodes/4/skin", 5), "nodes[4].skin: there is no skins[5]; there are 1");
  EXPECT_EQ(refusalWith("/nodes/2/extensions/KHR_lights_punctual/light", 5),
            "nodes[2].extensions.KHR_lights_punctual.light: there is no "
            "extensions.KHR_lights_punctual.lights[5]; there are 1");
  EXPECT_EQ(refusalWith("/meshes/0/primitives/0/material", 3),
            "meshes[0].primitives[0].material: there is no materials[3]; there are 1");
  EXPECT_EQ(refusalWith("/meshes/0/primitives/0/attributes/POSITION", 30),
            "meshes[0].primitives[0].attributes.POSITION: there is no accessors[30]; there are 8");
  EXPECT_EQ(refusalWith("/accessors/0/bufferView", 30),
            "accessors[0].bufferView: there is no bufferViews[30]; there are 8");
  EXPECT_EQ(refusalWith("/bufferViews/0/buffer", 1),
            "bufferViews[0].buffer: there is no buffers[1]; there are 1");
  EXPECT_EQ(refusalWith("/materials/0/normalTexture/index", 1),
            "materials[0].normalTexture.index: there is no textures[1]; there are 1");
  EXPECT_EQ(refusalWith("/textures/0/source", 2), "textures[0].source: there is no images[2]; there are 1");
  EXPECT_EQ(refusalWith("/textures/0/sampler", 2),
            "textures[0].sampler: there is no samplers[2]; there are 1");
  EXPECT_EQ(refusalWith("/animations/0/channels/0/sampler", 2),
            "animations[0]: a channel asks for samplers[2]; there are 1");
  EXPECT_EQ(refusalWith("/skins/0/joints/0", -1), "skins[0].joints[0]: -1 is out of range");
}

TEST(GltfRefusal, RefusesVerticesAndJointsOutOfRange) {
  EXPECT_EQ(refusalOf([](GltfSample& sample) {
              const std::uint16_t beyond[3] = {0, 1, 3};
              std::memcpy(sample.buffer.data() + sample.json["bufferViews"][4]["byteOffset"].get<int>(),
                          beyond, 6);
            }),
            "meshes[0].primitives[0].indices: vertex 3 is out of range; there are 3");
  EXPECT_EQ(refusalOf([](GltfSample& sample) {
              sample.buffer[sample.json["bufferViews"][3]["byteOffset"].get<std::size_t>()] = 9;
            }),
            "meshes[0].primitives[0].attributes.JOINTS_0: joint 9 is out of range; the skin has 1");
}

TEST(GltfRefusal, RefusesNodesThatAreNoTrees) {
  EXPECT_EQ(refusalOf([](GltfSample& sample) {
              sample.json["nodes"][3]["children"] = {0};
              sample.json["scenes"][0]["nodes"] = {4};
            }),
            "nodes[0]: it is its own ancestor: the nodes form a cycle");
  EXPECT_EQ(refusalWith("/nodes/4/children", {1}), "nodes[1]: it is a child of both nodes[0] and nodes[4]");
  EXPECT_EQ(refusalWith("/nodes/4/children", {4}),
            "nodes[4]: it is its own ancestor: the nodes form a cycle");
  EXPECT_EQ(refusalWith("/scenes/0/nodes", {0, 0}), "scenes[0]: it lists nodes[0] twice");
}

TEST(GltfRefusal, RefusesDataThatReachOutOfTheirBuffers) {
  const std::size_t size = GltfSample().buffer.size();
  EXPECT_EQ(refusalWith("/buffers/0/byteLength", size + 1),
            "buffers[0]: byteLength is " + std::to_string(size + 1) + " where there are " +
                std::to_string(size) + " bytes");
  EXPECT_EQ(refusalWith("/bufferViews/0/byteLength", 10000),
            "bufferViews[0]: 10000 bytes from byte 0 on reach past the " + std::to_string(size) +
                " bytes of its buffer");
  EXPECT_EQ(refusalWith("/accessors/0/count", 4),
            "accessors[0]: 4 elements of 12 bytes need 48 bytes; its bufferView has 36");
  EXPECT_EQ(refusalWith("/accessors/0/byteOffset", 4),
            "accessors[0]: 3 elements of 12 bytes need 40 bytes; its bufferView has 36");
  EXPECT_EQ(refusalWith("/accessors/0/count", 2000000000),
            "accessors[0]: count 2000000000 is more than the 33554432 that can be opened");
  EXPECT_EQ(refusalWith("/bufferViews/0/byteStride", 6),
            "bufferViews[0]: byteStride 6 is none of 4, 8, … 252");
  EXPECT_EQ(refusalWith("/bufferViews/0/byteStride", 24),
            "accessors[0]: 3 elements of 12 bytes need 60 bytes; its bufferView has 36");
  EXPECT_EQ(refusalWith("/accessors/0/componentType", 7), "accessors[0]: componentType 7 does not exist");
  EXPECT_EQ(refusalWith("/accessors/0/type", "VEC9"), "accessors[0]: type \"VEC9\" does not exist");
}

TEST(GltfRefusal, RefusesSparseIndicesOutOfRange) {
  EXPECT_EQ(refusalOf([](GltfSample& sample) {
              const std::uint8_t which[4] = {3};
              const int indices = sample.addView(which, 1);
              sample.json["accessors"][0]["sparse"] = {
                  {"count", 1},
                  {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                  {"values", {{"bufferView", 0}}}};
            }),
            "meshes[0].primitives[0].accessors[0]: sparse index 3 is out of range; there are 3 elements");
}

TEST(GltfRefusal, RefusesFilesOutsideItsFolder) {
  test::writeTemporary("secret.bin", std::string(1000, 'x'));
  for (const std::string uri :
       {"../secret.bin", "a/../../secret.bin", "%2e%2e/secret.bin", "/etc/passwd", "file:///etc/passwd",
        "http://example.com/a.bin", "..\\secret.bin", "C:\\a.bin"}) {
    GltfSample sample;
    sample.json["buffers"][0]["uri"] = uri;
    const std::string text = refusal(test::writeTemporary("inside/outside.gltf", sample.json.dump()));
    EXPECT_TRUE(text.starts_with("buffers[0]: ") &&
                text.ends_with("is not a file below the folder of the scene; only such files are opened"))
        << text;
  }
}

TEST(GltfRefusal, RefusesLinksOutOfItsFolder) {
  GltfSample sample;
  const fs::path outside = test::writeTemporary("aside.bin", sample.buffer);
  sample.json["buffers"][0]["uri"] = "link.bin";
  const fs::path file = test::writeTemporary("linked/it.gltf", sample.json.dump());
  fs::create_symlink(outside, file.parent_path() / "link.bin");
  EXPECT_EQ(refusal(file), "buffers[0]: link.bin leads out of the folder; only files below it are opened");
  fs::remove(file.parent_path() / "link.bin");
  test::writeTemporary("linked/other.bin", sample.buffer);
  fs::create_symlink("other.bin", file.parent_path() / "link.bin");
  EXPECT_EQ(refusal(file), "it opened");
}

TEST(GltfRefusal, RefusesMissingAndUnreadableData) {
  GltfSample sample;
  EXPECT_EQ(refusal(test::writeTemporary("bufferless.gltf", sample.json.dump())),
            "buffers[0]: it has no uri and there is no binary chunk for it");
  sample.json["buffers"][0]["uri"] = "gone.bin";
  EXPECT_EQ(refusal(test::writeTemporary("gone.gltf", sample.json.dump())),
            "buffers[0]: there is no file \"gone.bin\" beside it");
  sample.json["buffers"][0]["uri"] = "data:application/octet-stream;base64,AA*A";
  EXPECT_EQ(refusal(test::writeTemporary("base64.gltf", sample.json.dump())),
            "buffers[0]: its data URI is not valid base64");
  sample.json["buffers"][0]["uri"] = "data:application/pdf,hello";
  EXPECT_EQ(refusal(test::writeTemporary("pdf.gltf", sample.json.dump())),
            "buffers[0]: its data URI is not base64 of a buffer, PNG or JPEG");
}

TEST(GltfRefusal, RefusesPositionsAndBoundsThatAreNotFinite) {
  for (const float value : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
    EXPECT_EQ(refusalOf([&](GltfSample& sample) { std::memcpy(sample.buffer.data() + 16, &value, 4); }),
              "meshes[0].primitives[0].attributes.POSITION: a position is not a finite number");
  EXPECT_EQ(refusalWith("/nodes/0/scale", {3e38, 1, 1e30}), "bounds: the scene reaches to infinity");
  EXPECT_EQ(refusalOf([](GltfSample& sample) {
              for (const int node : {0, 1}) sample.json["nodes"][std::size_t(node)]["scale"] = {3e38, 1, 1};
            }),
            "nodes[1]: its transform is not finite");
  EXPECT_EQ(refusalWith("/nodes/0/scale", {1e300, 1, 1}), "nodes[0].scale: too large a number");
}

TEST(GltfRefusal, RefusesPropertiesOfTheWrongType) {
  EXPECT_EQ(refusalWith("/animations", 5), "animations: not a list");
  EXPECT_EQ(refusalWith("/nodes/0", 5), "nodes[0]: not an object");
  EXPECT_EQ(refusalWith("/nodes/0/name", 5), "nodes[0].name: not a text");
  EXPECT_EQ(refusalWith("/nodes/0/scale", {1, 2}), "nodes[0].scale: not a list of 3 numbers");
  EXPECT_EQ(refusalWith("/nodes/0/scale", {1, 2, "3"}), "nodes[0].scale: not a number");
  EXPECT_EQ(refusalWith("/meshes/0/primitives", json::array()), "meshes[0].primitives: not a list, or empty");
  EXPECT_EQ(refusalWith("/meshes/0/primitives/0/mode", 9), "meshes[0].primitives[0].mode: 9 does not exist");
  EXPECT_EQ(refusalWith("/materials/0/doubleSided", 1), "materials[0].doubleSided: neither true nor false");
  EXPECT_EQ(refusalWith("/accessors/0/count", 1.5), "accessors[0].count: not a whole number");
  EXPECT_EQ(refusalWith("/accessors/0/count", 0), "accessors[0].count: it is 0");
  EXPECT_EQ(refusalOf([](GltfSample& sample) { sample.json["accessors"][0].erase("type"); }),
            "accessors[0].type: missing");
  for (const char* list : {"scenes", "nodes", "meshes", "materials", "accessors", "bufferViews"})
    EXPECT_EQ(refusalWith("/" + std::string(list), 5), std::string(list) + ": not a list");
  EXPECT_EQ(refusalWith("/asset", 5), "asset: not an object");
  EXPECT_EQ(refusalWith("/cameras", json::array({{{"type", "no\npe"}}})),
            "cameras[0].type: \"no?pe\" is neither perspective nor orthographic");
  EXPECT_EQ(refusalWith("/cameras", json::array({{{"type", "perspective"}}})),
            "cameras[0].perspective: missing");
  EXPECT_EQ(refusalOf([](GltfSample& sample) {
              sample.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "spot"}}};
            }),
            "extensions.KHR_lights_punctual.lights[0]: it is a spot without \"spot\"");
  EXPECT_EQ(refusalWith("/meshes/0/primitives/0/attributes/POSITION", 1),
            "meshes[0].primitives[0].attributes.POSITION: it has 2 components");
}

TEST(GltfRefusal, RefusesAnimationsThatDoNotFitTogether) {
  EXPECT_EQ(refusalWith("/accessors/7/count", 1), "animations[0].channels[0]: it has 1 values for 2 times");
  EXPECT_EQ(refusalWith("/animations/0/samplers/0/interpolation", "MAGIC"),
            "animations[0].channels[0]: interpolation \"MAGIC\" does not exist");
  EXPECT_EQ(refusalWith("/animations/0/samplers/0/input", 0),
            "animations[0].channels[0]: its times are not single numbers");
}

TEST(GltfRefusal, GoesOnAfterARefusal) {
  EXPECT_NE(refusalWith("/asset/version", "1.0"), "it opened");
  EXPECT_EQ(refusalOf([](GltfSample&) {}), "it opened");
}

} // namespace
} // namespace taa
