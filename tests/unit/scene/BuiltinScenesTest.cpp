// The built-in scenes.
#include "core/base/Error.h"
#include "core/scene/MotionMode.h"
#include "core/scene/Pose.h"
#include "core/scene/builtin/SceneSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace taa {
namespace {

class BuiltinScenes : public testing::TestWithParam<std::string> {
 protected:
  const Scene scene_ = openScene("builtin:" + GetParam());
  /// The scenes a newcomer sees first are rich.
  bool isShowpiece() const { return GetParam() == "fan" || GetParam() == "fence"; }
  /// This one is there to be large.
  bool isCrowd() const { return GetParam() == "crowd"; }
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
    for (const TextureSlot& slot :
         {material.baseColorTexture, material.metallicRoughnessTexture, material.normalTexture,
          material.occlusionTexture, material.emissiveTexture}) {
      EXPECT_GE(slot.image, -1);
      EXPECT_LT(slot.image, int(scene_.images.size()));
    }
  for (const Light& light : scene_.lights) EXPECT_LT(std::size_t(light.node), scene_.nodes.size());
  for (const SceneCamera& camera : scene_.cameras) EXPECT_LT(std::size_t(camera.node), scene_.nodes.size());
}

TEST_P(BuiltinScenes, HasMaterialsThatReflectNoMoreThanTheyGet) {
  for (const Material& material : scene_.materials) {
    for (const float value : {material.baseColor.x, material.baseColor.y, material.baseColor.z,
                              material.baseColor.w, material.metallic, material.roughness}) {
      EXPECT_GE(value, 0.0f);
      EXPECT_LE(value, 1.0f);
    }
    for (int channel = 0; channel < 3; ++channel) {
      EXPECT_GE(material.emissive[channel], 0.0f);
      EXPECT_LE(material.emissive[channel], 1000.0f); // far from the brightest half float, 65504
    }
  }
}

TEST_P(BuiltinScenes, HasPicturesOfTheSizeTheySay) {
  for (const SceneImage& image : scene_.images)
    EXPECT_EQ(image.rgba.size(), 4u * std::size_t(image.width) * std::size_t(image.height)) << image.name;
}

TEST_P(BuiltinScenes, HasAnimationsOfNodesThatExistWithRisingTimes) {
  for (const Animation& animation : scene_.animations)
    for (const AnimationChannel& channel : animation.channels) {
      ASSERT_LT(std::size_t(channel.node), scene_.nodes.size());
      ASSERT_FALSE(channel.times.empty());
      EXPECT_TRUE(std::ranges::adjacent_find(channel.times, std::ranges::greater_equal{}) ==
                  channel.times.end());
      EXPECT_LE(channel.times.back(), animation.duration);
      if (channel.path == AnimationPath::Weights) continue;
      const std::size_t each = channel.interpolation == Interpolation::CubicSpline ? 3 : 1;
      EXPECT_EQ(channel.values.size(), each * channel.times.size());
    }
}

TEST_P(BuiltinScenes, HasFiniteBounds) {
  ASSERT_FALSE(scene_.bounds.isEmpty());
  EXPECT_TRUE(std::isfinite(scene_.bounds.radius()));
  EXPECT_GT(scene_.bounds.radius(), 0.5f);
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
  EXPECT_GT(triangles, isShowpiece() ? 15000u : 7u); // text is pictures on quads
  EXPECT_LT(triangles, isCrowd() ? 2000000u : 60000u);
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
  EXPECT_GT(inside, isShowpiece() ? 3000u : 7u);
}

bool isSame(const Vertex& a, const Vertex& b) {
  return a.position == b.position && a.normal == b.normal && a.tangent == b.tangent && a.uv0 == b.uv0 &&
         a.uv1 == b.uv1 && a.color == b.color;
}

TEST_P(BuiltinScenes, IsTheSameEachTime) {
  const Scene again = openScene("builtin:" + GetParam());
  ASSERT_EQ(scene_.images.size(), again.images.size());
  for (std::size_t i = 0; i < scene_.images.size(); ++i)
    EXPECT_EQ(scene_.images[i].rgba, again.images[i].rgba) << scene_.images[i].name;
  ASSERT_EQ(scene_.meshes.size(), again.meshes.size());
  for (std::size_t i = 0; i < scene_.meshes.size(); ++i) {
    const std::vector<Primitive>&parts = scene_.meshes[i].primitives, &others = again.meshes[i].primitives;
    ASSERT_EQ(parts.size(), others.size());
    for (std::size_t part = 0; part < parts.size(); ++part) {
      EXPECT_EQ(parts[part].indices, others[part].indices);
      EXPECT_TRUE(std::ranges::equal(parts[part].vertices, others[part].vertices, isSame));
    }
  }
  for (const double time : {0.0, 1.23, 3.9})
    EXPECT_EQ(poseAt(scene_, time).worldFromNode, poseAt(again, time).worldFromNode);
}

std::vector<std::string> ids() {
  std::vector<std::string> all;
  for (const BuiltinScene& scene : builtinScenes()) all.push_back(scene.id);
  return all;
}

INSTANTIATE_TEST_SUITE_P(All, BuiltinScenes, testing::ValuesIn(ids()),
                         [](const auto& test) { return test.param; });

/// Corners of a quad in pixels of a 960 × 540 picture at a frame of the thin scene.
std::vector<glm::dvec2> cornersPx(const Scene& scene, std::size_t node, int frame) {
  const CameraState camera = cameraAt(scene, scene.shot.camera, frame / 60.0, 16.0f / 9.0f);
  const glm::mat4 clipFromModel =
      camera.clipFromView * camera.viewFromWorld * poseAt(scene, frame / 60.0).worldFromNode[node];
  std::vector<glm::dvec2> corners;
  for (const Vertex& vertex : scene.meshes[std::size_t(scene.nodes[node].mesh)].primitives.front().vertices) {
    const glm::dvec4 clip(clipFromModel * glm::vec4(vertex.position, 1.0f));
    corners.emplace_back((1.0 + clip.x / clip.w) * 480.0, (1.0 - clip.y / clip.w) * 270.0);
  }
  return corners;
}

TEST(BuiltinScene, OfLinesCoversAsManyPixelsAsItSays) {
  const Scene scene = openScene("builtin:thin");
  const std::map<std::string, double> areas{{"one pixel", 85.0}, {"half a pixel", 42.5}, {"shallow", 800.0}};
  std::map<std::string, int> counts;
  for (std::size_t node = 0; node < scene.nodes.size(); ++node) {
    const auto area = areas.find(scene.nodes[node].name);
    if (area == areas.end()) continue;
    ++counts[area->first];
    for (int frame = 0; frame < scene.shot.frames; frame += 20) {
      const std::vector<glm::dvec2> corners = cornersPx(scene, node, frame);
      ASSERT_EQ(corners.size(), 4u);
      double covered = 0.0; // the shoelace formula
      for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec2 &a = corners[i], &b = corners[(i + 1) % 4];
        covered += 0.5 * (a.y * b.x - a.x * b.y);
        EXPECT_TRUE(a.x > 0.0 && a.x < 960.0 && a.y > 0.0 && a.y < 540.0)
            << area->first << " leaves the picture";
      }
      // Corners are floats, exact to 2⁻¹⁵ of a pixel here, across lines of up to 800 pixels.
      EXPECT_NEAR(covered, area->second, area->second * 1e-3) << area->first << ", frame " << frame;
    }
  }
  EXPECT_EQ(counts, (std::map<std::string, int>{{"one pixel", 18}, {"half a pixel", 18}, {"shallow", 5}}));
}

TEST(BuiltinScene, OfLinesDriftsByLessThanAThirdOfAPixelAFrame) {
  const Scene scene = openScene("builtin:thin");
  std::size_t node = 0;
  while (scene.nodes[node].name != "half a pixel") ++node;
  for (int frame = 1; frame < scene.shot.frames; ++frame) {
    const double step = glm::distance(cornersPx(scene, node, frame)[0], cornersPx(scene, node, frame - 1)[0]);
    EXPECT_GT(step, 0.1) << frame;
    EXPECT_LT(step, 1.0 / 3.0) << frame;
  }
}

TEST(BuiltinScene, OfFirefliesHasSparksSmallerThanAPixelOf720Lines) {
  const Scene scene = openScene("builtin:fireflies");
  const CameraState camera = cameraAt(scene, scene.shot.camera, 0.0, 16.0f / 9.0f);
  constexpr std::size_t kVertices = 4 * 7; // of a spark: a ball of six segments
  int sparks = 0;
  for (int frame = 0; frame < scene.shot.frames; frame += 40) {
    const Pose pose = poseAt(scene, frame / 60.0);
    for (std::size_t node = 0; node < scene.nodes.size(); ++node) {
      if (scene.nodes[node].name != "still sparks" && scene.nodes[node].name != "swarm") continue;
      const glm::mat4 view = camera.viewFromWorld * pose.worldFromNode[node];
      for (const Primitive& primitive : scene.meshes[std::size_t(scene.nodes[node].mesh)].primitives)
        for (std::size_t i = 0; i + kVertices <= primitive.vertices.size(); i += kVertices, ++sparks) {
          const glm::vec3 top = primitive.vertices[i].position,
                          bottom = primitive.vertices[i + kVertices - 1].position;
          const float distance = -(view * glm::vec4(0.5f * (top + bottom), 1.0f)).z;
          EXPECT_LT(0.5f * 720.0f * camera.clipFromView[1][1] * glm::distance(top, bottom) / distance, 1.0f);
        }
    }
  }
  EXPECT_EQ(sparks, 6 * (110 + 110 + 3 * 60));
}

TEST(BuiltinScene, OfLightsGivesTheGlowNoMotionWhenALampSwitches) {
  const Scene scene = openScene("builtin:lights");
  int glows = 0;
  for (std::size_t glow = 0; glow < scene.nodes.size(); ++glow) {
    if (scene.nodes[glow].name != "glow") continue;
    ++glows;
    int switches = 0;
    const auto burns = [&](int frame) { return poseAt(scene, frame / 60.0).worldFromNode[glow][3].y > 0.0f; };
    for (int frame = 1; frame < scene.shot.frames; ++frame) {
      const MotionMode mode = nodeStates(scene, {}, frame / 60.0, (frame - 1) / 60.0)[glow].mode;
      const bool switched = burns(frame) != burns(frame - 1);
      EXPECT_EQ(mode, switched ? MotionMode::CameraOnly : MotionMode::PerObject) << frame;
      switches += switched;
    }
    EXPECT_GE(switches, 1);
  }
  EXPECT_EQ(glows, 3);
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

TEST(BuiltinScene, OfGlassHasWhatNoMotionFollows) {
  const Scene scene = openScene("builtin:glass");
  int blended = 0, responsive = 0, flipBooks = 0, scrolling = 0;
  for (const Material& material : scene.materials) {
    blended += material.alphaMode == AlphaMode::Blend;
    responsive += material.responsive;
    flipBooks += material.uvAnimation.columns * material.uvAnimation.rows > 1;
    scrolling += material.uvAnimation.scroll != glm::vec2(0.0f);
    const glm::vec4 begin = animatedUv(material.uvAnimation, 0.0),
                    end = animatedUv(material.uvAnimation, 4.0);
    EXPECT_EQ(begin, end) << material.name << " loops with the shot";
  }
  EXPECT_EQ(blended, 5);
  EXPECT_EQ(responsive, 3);
  EXPECT_EQ(flipBooks, 1);
  EXPECT_EQ(scrolling, 1);
}

// Particles are where a parabola says, and their velocity is the way from the frame before.
TEST(BuiltinScene, OfGlassThrowsParticlesWhoseVelocityIsTheirWay) {
  const Scene scene = openScene("builtin:glass");
  const auto mesh = std::ranges::find(scene.meshes, "fountain", &Mesh::name);
  ASSERT_NE(mesh, scene.meshes.end());
  const Primitive& primitive = mesh->primitives.front();
  const std::size_t vertices = primitive.vertices.size();
  std::size_t born = 0;
  for (int frame = 0; frame < primitive.cache.frames; ++frame)
    for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
      const auto entry = [&](int at) -> const VertexCache::Entry& {
        const int wrapped = (at + primitive.cache.frames) % primitive.cache.frames;
        return primitive.cache.entries[static_cast<std::size_t>(wrapped) * vertices + vertex];
      };
      const glm::vec3 before = entry(frame).position - entry(frame).velocity / 60.0f;
      if (glm::distance(before, entry(frame - 1).position) > 1e-4f) ++born;
    }
  EXPECT_EQ(born, vertices) << "each is born once a loop, where its motion does not lead back";
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
