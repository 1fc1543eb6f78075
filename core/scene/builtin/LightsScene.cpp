// builtin:lights: lamps that switch on and off: the geometry of the history is right and its shading wrong.
#include "core/scene/builtin/BuiltinScenes.h"
#include "core/scene/builtin/ProceduralTextures.h"
#include "core/scene/builtin/SceneBuilder.h"

#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

namespace taa {

namespace {

/// A point light that burns in the steps where `pattern` has a 1 and lies far below else. Its bulb hangs
/// there all the time; only a thin glowing skin comes and goes with the light, at known moments, so that no
/// pixel's motion or depth tells of the change.
void addFlashingLamp(SceneBuilder& builder, const glm::vec3& place, const glm::vec3& color, float candela,
                     std::string_view pattern) {
  constexpr float kBulb = 0.07f, kSkin = 0.001f; // meters
  MeshBuilder fitting, skin;
  fitting.ball(place, kBulb, 20);
  const std::array<glm::vec3, 2> cord{place + glm::vec3(0, 3.0f, 0), place + glm::vec3(0, 0.5f * kBulb, 0)};
  fitting.tube(cord, 0.012f, 8);
  builder.addObject("fitting", {fitting.build(builder.addMaterial(paintOf(glm::vec3(0.03f), 0.4f)))});
  builder.addPointLight("lamp", place, color, candela);
  const int node = static_cast<int>(builder.scene().nodes.size()) - 1;
  skin.ball(glm::vec3(0.0f), kBulb + kSkin, 20);
  Material glow = paintOf(glm::vec3(0.02f), 0.6f);
  glow.emissive = 4.0f * color;
  builder.addObject("glow", {skin.build(builder.addMaterial(glow))}, node);
  const double seconds = 4.0 / static_cast<double>(pattern.size());
  std::vector<double>& jumps = builder.scene().nodes[static_cast<std::size_t>(node)].teleports;
  std::vector<glm::vec3> places;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    places.push_back(place - glm::vec3(0, pattern[i] == '1' ? 0.0f : 1000.0f, 0));
    if (i > 0 && pattern[i] != pattern[i - 1]) jumps.push_back(seconds * static_cast<double>(i));
  }
  places.push_back(places.front());
  builder.animateSteps(node, static_cast<float>(seconds), places);
}

} // namespace

Scene makeLightsScene() {
  SceneBuilder builder("builtin:lights");
  SurfaceImages bricks = brickImages();
  Material brick = paintOf(glm::vec3(1.0f), 0.85f), tile = paintOf(glm::vec3(1.0f), 0.35f);
  brick.baseColorTexture = textureSlot(builder.addImage(std::move(bricks.color)));
  brick.normalTexture = textureSlot(builder.addImage(std::move(bricks.normal)));
  tile.baseColorTexture = textureSlot(builder.addImage(tileImage()));
  MeshBuilder wall, floor, things, metal;
  wall.quad({-6.0f, 0.0f, -3.0f}, {12.0f, 0, 0}, {0, 4.5f, 0}, {9.0f, 3.4f});
  floor.quad({-6.0f, 0.0f, 4.0f}, {12.0f, 0, 0}, {0, 0, -7.0f}, {9.0f, 5.3f});
  for (int i = 0; i < 5; ++i) {
    const float x = -3.2f + 1.6f * static_cast<float>(i);
    (i % 2 == 0 ? things : metal).ball({x, 0.5f, -1.2f}, 0.5f, 48);
    things.box({x + 0.5f, 0.0f, -2.6f}, {x + 1.0f, 1.5f, -2.1f});
  }
  builder.addObject("wall", {wall.build(builder.addMaterial(brick))});
  builder.addObject("floor", {floor.build(builder.addMaterial(tile))});
  builder.addObject("things", {things.build(builder.addMaterial(paintOf({0.8f, 0.78f, 0.7f}, 0.6f))),
                               metal.build(builder.addMaterial(paintOf({0.9f, 0.75f, 0.5f}, 0.25f, 1.0f)))});
  addFlashingLamp(builder, {-2.4f, 2.4f, -0.4f}, {1.0f, 0.62f, 0.3f}, 9.0f, "11110000");
  addFlashingLamp(builder, {0.2f, 2.9f, -0.2f}, {0.5f, 0.75f, 1.0f}, 9.0f, "1011011101001101");
  addFlashingLamp(builder, {2.6f, 2.2f, -0.4f}, {1.0f, 0.25f, 0.2f}, 7.0f,
                  "10101010101010101010101010101010");
  const glm::vec3 eye(0.0f, 1.7f, 5.2f);
  const int camera = builder.addCamera("front", eye, {0.0f, -0.1f, -1.0f}, 0.75f);
  builder.animateLoop(
      camera, 4.0f, [&](float angle) { return eye + glm::vec3(0.15f * std::sin(angle), 0, 0); },
      [](float angle) { return glm::vec3(0.15f * std::cos(angle), 0, 0); });
  Scene& scene = builder.scene();
  scene.sky.zenith = {0.02f, 0.025f, 0.05f};
  scene.sky.horizon = {0.05f, 0.05f, 0.07f};
  scene.sky.ground = {0.02f, 0.02f, 0.02f};
  scene.sky.sunEnabled = false;
  scene.shot = {240, 60.0, "gltf:front", {}};
  return builder.finish();
}

} // namespace taa
