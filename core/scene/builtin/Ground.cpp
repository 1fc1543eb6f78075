#include "core/scene/builtin/Ground.h"

#include "core/scene/builtin/MeshBuilder.h"
#include "core/scene/builtin/ProceduralTextures.h"
#include "core/scene/builtin/SceneBuilder.h"

#include <cassert>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace taa {

namespace {

constexpr float kFloorReach = 6.0f;  // of the floor's radius to the model's
constexpr float kFloorTiles = 12.0f; // across the floor
constexpr float kFloorBelow = 1e-3f; // of the model's radius: what lies on the floor does not flicker with it
constexpr std::uint32_t kFloorCorners = 96;

/// Around `foot`, facing up.
Primitive disc(const glm::vec3& foot, float radius, int material) {
  Primitive primitive;
  primitive.material = material;
  const auto add = [&](const glm::vec2& place) {
    Vertex vertex;
    vertex.position = foot + radius * glm::vec3(place.x, 0.0f, place.y);
    vertex.normal = {0.0f, 1.0f, 0.0f};
    vertex.tangent = {1.0f, 0.0f, 0.0f, 1.0f};
    vertex.uv0 = 0.5f * kFloorTiles * place;
    primitive.vertices.push_back(vertex);
    primitive.bounds.add(vertex.position);
  };
  add({0.0f, 0.0f});
  for (std::uint32_t i = 0; i < kFloorCorners; ++i) {
    const float angle = kTurn * static_cast<float>(i) / kFloorCorners;
    add({std::sin(angle), std::cos(angle)});
    primitive.indices.insert(primitive.indices.end(), {0, 1 + i, 1 + (i + 1) % kFloorCorners});
  }
  return primitive;
}

/// The model and its shadow on the floor at height `floor`.
Bounds withShadow(const Scene& scene, float floor) {
  const glm::vec3 toSun = scene.sky.sunDirection;
  Bounds around = scene.bounds;
  for (const float x : {scene.bounds.min.x, scene.bounds.max.x})
    for (const float z : {scene.bounds.min.z, scene.bounds.max.z}) {
      const glm::vec3 top(x, scene.bounds.max.y, z);
      around.add(top - toSun * ((top.y - floor) / toSun.y));
    }
  return around;
}

} // namespace

bool isModelAlone(const Scene& scene) {
  const float radius = scene.bounds.radius();
  return scene.lights.empty() && scene.cameras.empty() && std::isfinite(radius) && radius > 0.0f;
}

void addGround(Scene& scene) {
  assert(isModelAlone(scene) && scene.sky.sunDirection.y > 0.0f);
  const float radius = scene.bounds.radius();
  glm::vec3 foot = scene.bounds.center();
  foot.y = scene.bounds.min.y - kFloorBelow * radius;

  Material floor = paintOf(glm::vec3(1.0f), 0.9f);
  floor.name = kGroundName;
  floor.baseColorTexture = textureSlot(static_cast<int>(scene.images.size()));
  scene.images.push_back(slabImage());
  Mesh mesh;
  mesh.name = kGroundName;
  mesh.primitives.push_back(disc(foot, kFloorReach * radius, static_cast<int>(scene.materials.size())));
  scene.materials.push_back(std::move(floor));
  Node node;
  node.name = kGroundName;
  node.mesh = static_cast<int>(scene.meshes.size());
  scene.meshes.push_back(std::move(mesh));
  scene.nodes.push_back(std::move(node));

  scene.sky.shadows = SunShadows::Soft;
  scene.sky.shadowed = withShadow(scene, foot.y);
}

} // namespace taa
