// Tests that every model of the shared data opens with what is in it, or is refused with the right sentence.
#include "core/base/Error.h"
#include "core/scene/Pose.h"
#include "core/scene/ShotChoice.h"
#include "core/scene/builtin/SceneSource.h"
#include "core/scene/gltf/GltfLoader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace taa {
namespace {

namespace fs = std::filesystem;

/// The file of a shared model; skips the test where the shared data are not there.
#define MODEL(name)                                                                                          \
  fs::path(TAA_SHARED_DATA) / "models" / (name);                                                             \
  if (!fs::exists(fs::path(TAA_SHARED_DATA) / "models"))                                                     \
  GTEST_SKIP() << "no shared data at " << TAA_SHARED_DATA

std::vector<fs::path> modelFiles() {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry :
       fs::recursive_directory_iterator(fs::path(TAA_SHARED_DATA) / "models"))
    if (entry.path().extension() == ".gltf" || entry.path().extension() == ".glb")
      files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

bool isFinite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// What must hold for every scene, whatever the file.
void expectWhole(const Scene& scene) {
  ASSERT_FALSE(scene.materials.empty());
  ASSERT_TRUE(isFinite(scene.bounds.min) && isFinite(scene.bounds.max));
  ASSERT_FALSE(scene.bounds.isEmpty());
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    ASSERT_LT(scene.nodes[i].parent, int(i));
    ASSERT_LT(scene.nodes[i].mesh, int(scene.meshes.size()));
  }
  for (const Mesh& mesh : scene.meshes)
    for (const Primitive& primitive : mesh.primitives) {
      ASSERT_LT(std::size_t(primitive.material), scene.materials.size());
      for (const std::uint32_t index : primitive.indices) ASSERT_LT(index, primitive.vertices.size());
      for (const Vertex& vertex : primitive.vertices) {
        ASSERT_TRUE(isFinite(vertex.position));
        ASSERT_NEAR(glm::length(vertex.normal), 1.0f, 1e-4f);
      }
    }
  for (const SceneImage& image : scene.images)
    ASSERT_EQ(image.rgba.size(), std::size_t(image.width) * image.height * 4);
  for (const Animation& animation : scene.animations)
    for (const AnimationChannel& channel : animation.channels)
      ASSERT_TRUE(std::ranges::is_sorted(channel.times, std::less_equal<>()));
  for (const std::string& camera : cameraNames(scene)) cameraAt(scene, camera, 0.5, 1.5f);
}

/// What the file needs that is not supported, as its folder's name tells; empty: nothing.
std::string missingExtension(const std::string& file) {
  if (file.find("Draco") != std::string::npos) return "KHR_draco_mesh_compression";
  return file.find("Meshopt") != std::string::npos ? "EXT_meshopt_compression" : "";
}

TEST(GltfModels, AllOpenOrSayWhichExtensionTheyNeed) {
  const fs::path folder = MODEL("");
  int opened = 0, refused = 0;
  for (const fs::path& file : modelFiles()) {
    SCOPED_TRACE(file.string());
    const std::string extension = missingExtension(file.string());
    try {
      expectWhole(openScene(file.string()));
      EXPECT_EQ(extension, "");
      ++opened;
    } catch (const Error& error) {
      const std::string sentence = "extensionsRequired: it needs the extension " + extension +
                                   ", which is not supported; export it without";
      EXPECT_EQ(std::string(error.what()), "cannot open " + file.string() + ": " + sentence);
      ++refused;
    }
  }
  EXPECT_EQ(opened, 47);
  EXPECT_EQ(refused, 4);
}

TEST(GltfModels, AreTheSameFromEveryContainer) {
  const fs::path box = MODEL("Box");
  const Scene separate = loadGltf(box / "glTF/Box.gltf");
  ASSERT_EQ(separate.meshes.size(), 1u);
  const Primitive& expected = separate.meshes[0].primitives.at(0);
  EXPECT_EQ(expected.vertices.size(), 24u);
  EXPECT_EQ(expected.indices.size(), 36u);
  for (const char* other : {"glTF-Binary/Box.glb", "glTF-Embedded/Box.gltf"}) {
    const Scene scene = loadGltf(box / other);
    const Primitive& primitive = scene.meshes.at(0).primitives.at(0);
    EXPECT_EQ(primitive.indices, expected.indices);
    for (std::size_t i = 0; i < expected.vertices.size(); ++i)
      EXPECT_EQ(primitive.vertices.at(i).position, expected.vertices[i].position);
  }
}

TEST(GltfModels, StandUprightInTheirPoseAtRest) {
  const fs::path file = MODEL("CesiumMan/glTF-Binary/CesiumMan.glb");
  const Bounds bounds = openScene(file.string()).bounds;
  EXPECT_NEAR(bounds.max.y - bounds.min.y, 1.5f, 0.1f) << "a man's height in meters";
  EXPECT_GT(bounds.max.y - bounds.min.y, bounds.max.z - bounds.min.z);
}

TEST(GltfModels, ShowOnlyTheDefaultScene) {
  const fs::path file = MODEL("MultipleScenes/glTF/MultipleScenes.gltf");
  const Scene scene = loadGltf(file);
  EXPECT_EQ(scene.nodes.size(), 1u);
  EXPECT_EQ(scene.warnings, std::vector<std::string>{"The file has 2 scenes; scenes[1] is shown."});
}

TEST(GltfModels, BringTheirCameras) {
  const fs::path file = MODEL("Cameras/glTF/Cameras.gltf");
  const Scene scene = openScene(file.string());
  ASSERT_EQ(scene.cameras.size(), 2u);
  EXPECT_FALSE(cameraAt(scene, "gltf:camera0", 0.0, 1.0f).orthographic);
  EXPECT_TRUE(cameraAt(scene, "gltf:camera1", 0.0, 1.0f).orthographic);
}

TEST(GltfModels, BringTheirLights) {
  const fs::path file = MODEL("LightsPunctualLamp/glTF/LightsPunctualLamp.gltf");
  const Scene scene = openScene(file.string());
  EXPECT_FALSE(scene.lights.empty());
  EXPECT_FALSE(scene.sky.sunEnabled);
}

TEST(GltfModels, DrawEveryInstance) {
  const fs::path file = MODEL("SimpleInstancing/glTF/SimpleInstancing.gltf");
  const Scene scene = loadGltf(file);
  int drawn = 0;
  for (const Node& node : scene.nodes) drawn += node.timesDrawn();
  EXPECT_EQ(drawn, 125);
}

TEST(GltfModels, HaveEveryInterpolation) {
  const fs::path file = MODEL("InterpolationTest/glTF/InterpolationTest.gltf");
  int counts[3] = {};
  const ShotChoice all{.animation = std::string(kAllAnimations)};
  for (const Animation& animation : openScene(file.string(), {}, all).animations)
    for (const AnimationChannel& channel : animation.channels) ++counts[std::size_t(channel.interpolation)];
  EXPECT_EQ(counts[0], 3);
  EXPECT_EQ(counts[1], 3);
  EXPECT_EQ(counts[2], 3);
}

TEST(GltfModels, GlowAsStronglyAsTheySay) {
  const fs::path file = MODEL("EmissiveStrengthTest/glTF-Binary/EmissiveStrengthTest.glb");
  float strongest = 0.0f;
  for (const Material& material : openScene(file.string()).materials)
    strongest = std::max({strongest, material.emissive.x, material.emissive.y, material.emissive.z});
  EXPECT_EQ(strongest, 16.0f * 0.9f) << "strength times factor";
}

TEST(GltfModels, GetTangentsForTheirNormalMaps) {
  const fs::path file = MODEL("NormalTangentTest/glTF-Binary/NormalTangentTest.glb");
  for (const Mesh& mesh : openScene(file.string()).meshes)
    for (const Primitive& primitive : mesh.primitives)
      for (const Vertex& vertex : primitive.vertices) {
        ASSERT_NEAR(glm::length(glm::vec3(vertex.tangent)), 1.0f, 1e-4f);
        ASSERT_NEAR(glm::dot(glm::vec3(vertex.tangent), vertex.normal), 0.0f, 1e-3f);
      }
}

TEST(GltfModels, AreTheSameQuantized) {
  const fs::path cube = MODEL("AnimatedMorphCube");
  const Bounds plain = openScene((cube / "glTF/AnimatedMorphCube.gltf").string()).bounds;
  const Bounds quantized = openScene((cube / "glTF-Quantized/AnimatedMorphCube.gltf").string()).bounds;
  const float step = 2.0f * plain.radius() / 255.0f; // 8 bits or more across the cube
  EXPECT_LT(glm::distance(plain.min, quantized.min), step);
  EXPECT_LT(glm::distance(plain.max, quantized.max), step);
}

} // namespace
} // namespace taa
