// The built-in scenes.
#include "core/base/Error.h"
#include "core/scene/Pose.h"
#include "core/scene/SceneSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace taa {
namespace {

class BuiltinScenes : public testing::TestWithParam<std::string> {
 protected:
  const Scene scene_ = openScene("builtin:" + GetParam());
};

TEST_P(BuiltinScenes, HasOnlyIndicesThatExist) {
  ASSERT_FALSE(scene_.materials.empty());
  for (const Mesh& mesh : scene_.meshes)
    for (const Primitive& primitive : mesh.primitives) {
      ASSERT_GE(primitive.material, 0);
      ASSERT_LT(primitive.material, int(scene_.materials.size()));
      ASSERT_EQ(primitive.indices.size() % 3, 0u);
      for (const std::uint32_t index : primitive.indices) ASSERT_LT(index, primitive.vertices.size());
    }
  for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
    EXPECT_LT(scene_.nodes[i].parent, int(i));
    EXPECT_LT(scene_.nodes[i].mesh, int(scene_.meshes.size()));
  }
  for (const Material& material : scene_.materials)
    for (const TextureSlot& slot : {material.baseColorTexture, material.normalTexture})
      EXPECT_LT(slot.image, int(scene_.images.size()));
}

/// Triangles of a mesh that are turned away from their own normals; those without an area have no side.
std::size_t trianglesTurnedAway(const Mesh& mesh) {
  std::size_t count = 0;
  for (const Primitive& primitive : mesh.primitives)
    for (std::size_t i = 0; i < primitive.indices.size(); i += 3) {
      const Vertex& a = primitive.vertices[primitive.indices[i]];
      const Vertex& b = primitive.vertices[primitive.indices[i + 1]];
      const Vertex& c = primitive.vertices[primitive.indices[i + 2]];
      const glm::vec3 face = glm::cross(b.position - a.position, c.position - a.position);
      count += glm::length(face) > 1e-9f && glm::dot(face, a.normal + b.normal + c.normal) < 0.0f;
    }
  return count;
}

TEST_P(BuiltinScenes, FacesPointWhereTheirNormalsPoint) {
  for (const Mesh& mesh : scene_.meshes) EXPECT_EQ(trianglesTurnedAway(mesh), 0u) << mesh.name;
}

TEST_P(BuiltinScenes, HasAsManyTrianglesAsASoftwareRasterizerDraws) {
  std::size_t triangles = 0;
  for (const Node& node : scene_.nodes)
    if (node.mesh >= 0)
      for (const Primitive& primitive : scene_.meshes[std::size_t(node.mesh)].primitives)
        triangles += primitive.indices.size() / 3;
  EXPECT_GE(triangles, 8u);
  EXPECT_LT(triangles, 60000u);
}

TEST_P(BuiltinScenes, HasUnitNormalsAndTangentsAcrossThem) {
  for (const Mesh& mesh : scene_.meshes)
    for (const Primitive& primitive : mesh.primitives)
      for (const Vertex& vertex : primitive.vertices) {
        ASSERT_NEAR(glm::length(vertex.normal), 1.0f, 1e-4f) << mesh.name;
        ASSERT_NEAR(glm::length(glm::vec3(vertex.tangent)), 1.0f, 1e-4f) << mesh.name;
        ASSERT_NEAR(glm::dot(vertex.normal, glm::vec3(vertex.tangent)), 0.0f, 1e-3f) << mesh.name;
        ASSERT_EQ(std::abs(vertex.tangent.w), 1.0f);
      }
}

TEST_P(BuiltinScenes, OpensWithACameraThatExists) {
  EXPECT_NO_THROW(cameraAt(scene_, scene_.shot.camera, 0.0, 16.0f / 9.0f));
  EXPECT_EQ(scene_.shot.frames, 240);
  EXPECT_EQ(scene_.shot.framesPerSecond, 60.0);
}

TEST_P(BuiltinScenes, LoopsWithTheShot) {
  ASSERT_FALSE(scene_.animations.empty());
  EXPECT_EQ(scene_.animations.front().duration, 4.0f);
  EXPECT_EQ(poseAt(scene_, 0.0).worldFromNode, poseAt(scene_, 4.0).worldFromNode);
}

TEST_P(BuiltinScenes, FillsTheViewOfItsCamera) {
  const CameraState camera = cameraAt(scene_, scene_.shot.camera, 0.0, 16.0f / 9.0f);
  const Pose pose = poseAt(scene_, 0.0);
  std::size_t inside = 0;
  for (std::size_t node = 0; node < scene_.nodes.size(); ++node) {
    if (scene_.nodes[node].mesh < 0) continue;
    for (const Primitive& primitive : scene_.meshes[std::size_t(scene_.nodes[node].mesh)].primitives)
      for (const Vertex& vertex : primitive.vertices) {
        const glm::vec4 clip = camera.clipFromView * camera.viewFromWorld * pose.worldFromNode[node] *
                               glm::vec4(vertex.position, 1.0f);
        inside += clip.w > 0.0f && std::abs(clip.x) < clip.w && std::abs(clip.y) < clip.w;
      }
  }
  EXPECT_GE(inside, 8u);
}

std::vector<std::string> ids() {
  std::vector<std::string> all;
  for (const BuiltinScene& scene : builtinScenes()) all.push_back(scene.id);
  return all;
}

INSTANTIATE_TEST_SUITE_P(All, BuiltinScenes, testing::ValuesIn(ids()),
                         [](const auto& test) { return test.param; });

TEST(BuiltinScene, OfLinesHasThemAsWideAsItSays) {
  const Scene scene = openScene("builtin:thin");
  const float pixel = scene.cameras.front().height / 540.0f;
  int wide = 0, half = 0;
  for (const Node& node : scene.nodes) {
    if (node.name != "one pixel" && node.name != "half a pixel") continue;
    const Primitive& line = scene.meshes[std::size_t(node.mesh)].primitives.front();
    const glm::vec3 &a = line.vertices[0].position, &b = line.vertices[1].position,
                    &c = line.vertices[2].position;
    const float width = std::min(glm::distance(a, b), glm::distance(b, c));
    EXPECT_NEAR(width / pixel, node.name == "one pixel" ? 1.0f : 0.5f, 1e-4f);
    ++(node.name == "one pixel" ? wide : half);
  }
  EXPECT_EQ(wide, 18);
  EXPECT_EQ(half, 18);
}

TEST(BuiltinScene, OfCutsJumpsWhereItCuts) {
  const Scene scene = openScene("builtin:cut");
  EXPECT_EQ(scene.shot.cuts, (std::vector<int>{60, 120, 180}));
  const auto eyeAt = [&](int frame) {
    return glm::inverse(cameraAt(scene, "gltf:cuts", frame / 60.0, 1.7f).viewFromWorld)[3];
  };
  for (const int cut : scene.shot.cuts) {
    EXPECT_GT(glm::distance(eyeAt(cut - 1), eyeAt(cut)), 50.0f) << cut;
    EXPECT_EQ(eyeAt(cut), eyeAt(cut + 1));
  }
}

TEST(BuiltinScene, OfTheGalleryHasEverySourceOfMotion) {
  const Scene scene = openScene("builtin:gallery");
  EXPECT_EQ(scene.skins.size(), 1u);
  EXPECT_EQ(scene.morphWeights.size(), 2u);
  bool cached = false, wind = false;
  for (const Mesh& mesh : scene.meshes)
    for (const Primitive& primitive : mesh.primitives) cached = cached || primitive.cache.frames > 1;
  for (const Material& material : scene.materials) wind = wind || material.wind.amplitude > 0.0f;
  EXPECT_TRUE(cached);
  EXPECT_TRUE(wind);
}

TEST(BuiltinScene, MovesTheFansBladesManyPixelsAFrame) {
  const Scene scene = openScene("builtin:fan");
  std::size_t rotor = 0;
  while (scene.nodes[rotor].name != "rotor") ++rotor;
  const glm::vec4 tip(1.13f, 0.0f, 0.0f, 1.0f);
  const auto pixel = [&](double time) {
    const CameraState camera = cameraAt(scene, "gltf:front", 0.0, 16.0f / 9.0f);
    const glm::vec4 clip =
        camera.clipFromView * camera.viewFromWorld * poseAt(scene, time).worldFromNode[rotor] * tip;
    return glm::vec2(clip) / clip.w * glm::vec2(640.0f, 360.0f);
  };
  EXPECT_GT(glm::distance(pixel(0.0), pixel(1.0 / 60.0)), 15.0f);
}

TEST(BuiltinScene, HasLightsBrighterThanWhite) {
  for (const std::string source : {"builtin:fan", "builtin:fence"}) {
    float brightest = 0.0f;
    for (const Material& material : openScene(source).materials)
      brightest = std::max(brightest, material.emissive.x);
    EXPECT_GT(brightest, 5.0f) << source;
  }
}

TEST(BuiltinScene, IsTheSameEachTime) {
  const Scene first = openScene("builtin:fan"), second = openScene("builtin:fan");
  ASSERT_EQ(first.images.size(), second.images.size());
  for (std::size_t i = 0; i < first.images.size(); ++i)
    EXPECT_EQ(first.images[i].rgba, second.images[i].rgba);
}

TEST(BuiltinScene, NamesThoseThereAreWhenAskedForAnother) {
  try {
    openScene("builtin:nothing");
    FAIL() << "opened";
  } catch (const Error& error) {
    const std::string text = error.what();
    EXPECT_TRUE(
        text.starts_with("there is no built-in scene \"nothing\"; there are builtin:fan, builtin:fence"))
        << text;
    for (const BuiltinScene& scene : builtinScenes())
      EXPECT_NE(text.find("builtin:" + scene.id), std::string::npos) << text;
  }
}

} // namespace
} // namespace taa
