// builtin:fireflies: sparks smaller than a pixel and up to a thousand times as bright as white, some of them
// moving, above a rough metal floor whose bumps glitter: what tone weights and the box are for.
#include "core/scene/builtin/BuiltinScenes.h"
#include "core/scene/builtin/ProceduralTextures.h"
#include "core/scene/builtin/SceneBuilder.h"

#include <cmath>
#include <utility>

namespace taa {

namespace {

/// Meters: the largest spark's radius. From the nearest of them, 4 m away, a pixel of 720 lines is 4.4 mm.
constexpr float kSpark = 0.002f;

Material sparkOf(const glm::vec3& radiance) {
  Material material = paintOf(glm::vec3(0.0f), 1.0f);
  material.emissive = radiance;
  return material;
}

/// Sparks spread by the R2 sequence over a box, `radius` meters each.
Primitive sparks(int count, float radius, int seed, int material) {
  MeshBuilder mesh;
  for (int i = 0; i < count; ++i) {
    const float n = static_cast<float>(i + 17 * seed);
    mesh.ball({-4.0f + 8.0f * glm::fract(0.7548777f * n), 0.2f + 2.6f * glm::fract(0.5698403f * n),
               -5.0f + 5.0f * glm::fract(0.3819660f * n)},
              radius, 6);
  }
  return mesh.build(material);
}

} // namespace

Scene makeFirefliesScene() {
  SceneBuilder builder("builtin:fireflies");
  Material floor = paintOf({0.5f, 0.5f, 0.55f}, 0.22f, 1.0f), wall = paintOf({0.8f, 0.75f, 0.7f}, 0.9f);
  SurfaceImages bricks = brickImages();
  wall.baseColorTexture = textureSlot(builder.addImage(std::move(bricks.color)));
  wall.normalTexture = textureSlot(builder.addImage(std::move(bricks.normal)));
  floor.normalTexture = wall.normalTexture;
  floor.normalTexture.sampler.mipmaps = Mipmaps::None; // bumps finer than a pixel stay: each sample its own
  MeshBuilder floorMesh, wallMesh, balls;
  floorMesh.quad({-7.0f, 0.0f, 4.0f}, {14.0f, 0, 0}, {0, 0, -10.0f}, {14.0f, 10.0f});
  wallMesh.quad({-7.0f, 0.0f, -6.0f}, {14.0f, 0, 0}, {0, 5.0f, 0}, {11.0f, 4.0f});
  for (int i = 0; i < 5; ++i) balls.ball({-3.0f + 1.5f * static_cast<float>(i), 0.4f, -1.4f}, 0.4f, 40);
  builder.addObject("floor", {floorMesh.build(builder.addMaterial(floor))});
  builder.addObject("wall", {wallMesh.build(builder.addMaterial(wall))});
  builder.addObject("balls", {balls.build(builder.addMaterial(paintOf({0.95f, 0.9f, 0.8f}, 0.12f, 1.0f)))});
  const int white = builder.addMaterial(sparkOf(glm::vec3(1000.0f))),
            gold = builder.addMaterial(sparkOf({400.0f, 180.0f, 30.0f})),
            blue = builder.addMaterial(sparkOf({20.0f, 60.0f, 200.0f}));
  builder.addObject("still sparks", {sparks(110, 0.75f * kSpark, 1, white), sparks(110, kSpark, 2, blue)});
  for (int swarm = 0; swarm < 3; ++swarm) {
    const int node = builder.addObject("swarm", {sparks(60, kSpark, 5 + swarm, swarm == 0 ? white : gold)});
    const float phase = 2.1f * static_cast<float>(swarm), reach = 0.25f + 0.3f * static_cast<float>(swarm);
    builder.animateLoop(
        node, 4.0f,
        [=](float angle) {
          return glm::vec3(reach * std::sin(angle + phase), 0.2f * std::cos(angle + phase), 0.0f);
        },
        [=](float angle) {
          return glm::vec3(reach * std::cos(angle + phase), -0.2f * std::sin(angle + phase), 0.0f);
        });
  }
  builder.addPointLight("warm", {-2.2f, 1.5f, -4.6f}, {1.0f, 0.7f, 0.4f}, 5.0f);
  builder.addPointLight("cold", {2.6f, 1.7f, -4.6f}, {0.4f, 0.6f, 1.0f}, 5.0f);
  builder.addCamera("front", {0.0f, 1.3f, 4.0f}, {0.0f, -0.06f, -1.0f}, 0.75f);
  Scene& scene = builder.scene();
  scene.sky.zenith = {0.02f, 0.025f, 0.06f};
  scene.sky.horizon = {0.03f, 0.03f, 0.05f};
  scene.sky.ground = {0.01f, 0.01f, 0.01f};
  scene.sky.sunEnabled = false;
  scene.shot = {240, 60.0, "gltf:front", {}};
  return builder.finish();
}

} // namespace taa
