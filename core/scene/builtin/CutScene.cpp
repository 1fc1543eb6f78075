// builtin:cut: the camera cuts between two places every second, and a ball jumps without a cut.
#include "core/scene/builtin/BuiltinScenes.h"
#include "core/scene/builtin/ProceduralTextures.h"
#include "core/scene/builtin/SceneBuilder.h"

#include <string>
#include <utility>
#include <vector>

namespace taa {

namespace {

constexpr float kApart = 60.0f; ///< meters between the two places

/// A wall, a floor and a few things before it, `x` meters to the right.
void addPlace(SceneBuilder& builder, const std::string& name, float x, int wall, int floor,
              const glm::vec3& tint) {
  MeshBuilder wallMesh, floorMesh, things;
  wallMesh.quad({x - 6.0f, 0.0f, -4.0f}, {12.0f, 0, 0}, {0, 5.0f, 0}, {9.0f, 3.75f});
  floorMesh.quad({x - 6.0f, 0.0f, 4.0f}, {12.0f, 0, 0}, {0, 0, -8.0f}, {9.0f, 6.0f});
  for (int i = 0; i < 7; ++i) {
    const float at = x - 3.0f + static_cast<float>(i);
    if (i % 2 == 0)
      things.ball({at, 0.45f, -1.5f + 0.3f * static_cast<float>(i % 3)}, 0.45f, 36);
    else
      things.box({at - 0.35f, 0.0f, -2.4f}, {at + 0.35f, 0.7f + 0.3f * static_cast<float>(i % 3), -1.7f});
  }
  builder.addObject(name + " wall", {wallMesh.build(wall)});
  builder.addObject(name + " floor", {floorMesh.build(floor)});
  builder.addObject(name + " things", {things.build(builder.addMaterial(paintOf(tint, 0.35f)))});
}

/// A ball that is somewhere else every half second. Where its jumps are `known`, it has no motion in those
/// frames (manual §3, rule 3); else its motion leads to where it was, far away.
void addJumper(SceneBuilder& builder, const std::string& name, const glm::vec3& glow, float z, bool known) {
  MeshBuilder ball;
  ball.ball({0, 0, 0}, 0.4f, 40);
  Material glowing = paintOf(glm::min(glow, glm::vec3(1.0f)), 0.5f);
  glowing.emissive = glow;
  const int node = builder.addObject(name, {ball.build(builder.addMaterial(glowing))});
  std::vector<glm::vec3> places;
  for (int i = 0; i < 8; ++i) {
    const float x = (known ? -1.6f : -2.4f) + 1.6f * static_cast<float>(i * 5 % 4);
    places.emplace_back(x + (i / 2 % 2 == 1 ? kApart : 0.0f),
                        1.3f + 0.8f * static_cast<float>((known ? i + 1 : i) % 3), z);
    if (known && i > 0) builder.scene().nodes.back().teleports.push_back(0.5 * i);
  }
  places.push_back(places.front());
  builder.animateSteps(node, 0.5f, places);
}

} // namespace

Scene makeCutScene() {
  SceneBuilder builder("builtin:cut");
  SurfaceImages bricks = brickImages(), planks = plankImages();
  Material brick = paintOf(glm::vec3(1.0f), 0.85f), plank = brick, tile = brick, gravel = brick;
  brick.baseColorTexture = textureSlot(builder.addImage(std::move(bricks.color)));
  brick.normalTexture = textureSlot(builder.addImage(std::move(bricks.normal)));
  plank.baseColorTexture = textureSlot(builder.addImage(std::move(planks.color)));
  plank.normalTexture = textureSlot(builder.addImage(std::move(planks.normal)));
  tile.baseColorTexture = textureSlot(builder.addImage(tileImage()));
  gravel.baseColorTexture = textureSlot(builder.addImage(gravelImage()));
  addPlace(builder, "first", 0.0f, builder.addMaterial(brick), builder.addMaterial(tile),
           {0.1f, 0.35f, 0.75f});
  addPlace(builder, "second", kApart, builder.addMaterial(plank), builder.addMaterial(gravel),
           {0.15f, 0.6f, 0.25f});
  addJumper(builder, "jumper", {1.2f, 0.3f, 0.05f}, -0.6f, false);
  addJumper(builder, "teleported", {0.05f, 0.4f, 1.2f}, -1.0f, true);
  const glm::vec3 eye(0.0f, 1.9f, 5.2f), there(kApart, 0, 0);
  const int camera = builder.addCamera("cuts", eye, {0.0f, -0.12f, -1.0f}, 0.75f);
  builder.animateSteps(camera, 1.0f, std::vector<glm::vec3>{eye, eye + there, eye, eye + there, eye});
  Scene& scene = builder.scene();
  scene.sky.sunDirection = {-0.5f, 0.8f, 0.6f};
  scene.shot = {240, 60.0, "gltf:cuts", {60, 120, 180}};
  return builder.finish();
}

} // namespace taa
