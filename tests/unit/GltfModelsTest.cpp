// Tests that every model of the shared data opens with what is in it, or is refused with the right sentence.
#include "core/base/Error.h"
#include "core/scene/Pose.h"
#include "core/scene/SceneSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

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

TEST(GltfModels, AllOpenOrSayWhichExtensionTheyNeed) {
  const fs::path folder = MODEL("");
  int opened = 0, refused = 0;
  for (const fs::path& file : modelFiles()) {
    SCOPED_TRACE(file.string());
    const std::string text = file.string();
    const bool draco = text.find("Draco") != std::string::npos,
               meshopt = text.find("Meshopt") != std::string::npos;
    try {
      expectWhole(openScene(text));
      EXPECT_FALSE(draco || meshopt);
      ++opened;
    } catch (const Error& error) {
      const std::string extension = draco     ? "KHR_draco_mesh_compression"
                                    : meshopt ? "EXT_meshopt_compression"
                                              : "none";
      EXPECT_EQ(std::string(error.what()), "cannot open " + text +
                                               ": extensionsRequired: it needs the extension " + extension +
                                               ", which is not supported; export it without");
      ++refused;
    }
  }
  EXPECT_EQ(opened, 47);
  EXPECT_EQ(refused, 4);
}

} // namespace
} // namespace taa
