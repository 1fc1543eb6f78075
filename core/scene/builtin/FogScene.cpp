// builtin:fog: the beams of two lamps in a hazy hall, marched in few steps: one rests, so that bands and what
// is left of noise can be looked at, the other sweeps, so that the fog of a moment ago is somewhere else.
#include "core/scene/builtin/BuiltinScenes.h"
#include "core/scene/builtin/ProceduralTextures.h"
#include "core/scene/builtin/SceneBuilder.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace taa {

namespace {

constexpr float kFogSeconds = 4.0f;

/// A lamp at its node's origin that shines along −z.
struct Lamp {
  std::string name;
  glm::vec3 color;
  float candela;
  float mouth;  ///< m, radius where its beam begins
  float reach;  ///< m
  float spread; ///< m, radius of the beam at its end
};

/// What of a lamp can be touched, then its light and the fog in it; all on one node.
void addFogLamp(SceneBuilder& builder, const Lamp& lamp, int parent, const glm::vec3& place,
                const glm::vec3& direction) {
  constexpr float kDepth = 0.34f;
  MeshBuilder body, glass;
  const float silhouette = 1.25f * lamp.mouth, neck = 0.45f * lamp.mouth;
  const std::array<glm::vec2, 6> outside{{{silhouette, 0.0f},
                                          {1.08f * silhouette, 0.02f},
                                          {silhouette, 0.04f},
                                          {silhouette, 0.5f * kDepth},
                                          {neck, kDepth},
                                          {0.0f, kDepth}}};
  body.lathe({0, 0, 0}, outside, 40);
  const std::array<glm::vec2, 3> disc{{{0.0f, -0.004f}, {0.9f * silhouette, -0.004f}, {silhouette, 0.0f}}};
  glass.lathe({0, 0, 0}, disc, 40);
  Material paint = paintOf(glm::vec3(0.04f), 0.35f, 0.6f), glow = paintOf(glm::vec3(0.02f), 0.6f);
  paint.doubleSided = true;
  glow.emissive = 6.0f * lamp.color;
  glow.doubleSided = true;
  const int node = builder.addObject(
      lamp.name, {body.build(builder.addMaterial(paint)), glass.build(builder.addMaterial(glow))}, parent);
  Scene& scene = builder.scene();
  Node& own = scene.nodes[static_cast<std::size_t>(node)];
  own.translation = place;
  own.rotation = lookRotation(direction);
  own.light = static_cast<int>(scene.lights.size());
  Light light;
  light.kind = LightKind::Spot;
  light.node = node;
  light.color = lamp.color;
  light.intensity = lamp.candela;
  light.outerConeAngle = std::atan2(lamp.spread, lamp.reach);
  light.innerConeAngle = 0.8f * light.outerConeAngle;
  scene.lights.push_back(light);
  scene.fog.push_back({.node = node,
                       .length = lamp.reach,
                       .startRadius = lamp.mouth,
                       .endRadius = lamp.spread,
                       .density = 0.22f,
                       .light = 0.9f * lamp.color,
                       .fading = 0.75f});
}

void addHall(SceneBuilder& builder) {
  SurfaceImages bricks = brickImages(), planks = plankImages();
  Material brick = paintOf(glm::vec3(0.8f), 0.85f), plank = paintOf(glm::vec3(0.7f), 0.5f);
  brick.baseColorTexture = textureSlot(builder.addImage(std::move(bricks.color)));
  brick.normalTexture = textureSlot(builder.addImage(std::move(bricks.normal)));
  plank.baseColorTexture = textureSlot(builder.addImage(std::move(planks.color)));
  plank.normalTexture = textureSlot(builder.addImage(std::move(planks.normal)));
  MeshBuilder wall, floor;
  wall.quad({-8.0f, 0.0f, -4.0f}, {16.0f, 0, 0}, {0, 6.0f, 0}, {10.0f, 3.75f});
  floor.quad({-8.0f, 0.0f, 5.0f}, {16.0f, 0, 0}, {0, 0, -9.0f}, {10.0f, 5.6f});
  builder.addObject("wall", {wall.build(builder.addMaterial(brick))});
  builder.addObject("floor", {floor.build(builder.addMaterial(plank))});
}

/// Things in the beams and before them: large calm ones to see bands on, thin ones for their edges.
void addThings(SceneBuilder& builder) {
  const int white = builder.addMaterial(paintOf({0.85f, 0.84f, 0.80f}, 0.6f));
  const int hemp = builder.addMaterial(paintOf({0.45f, 0.38f, 0.28f}, 0.8f));
  const int gold = builder.addMaterial(paintOf({0.95f, 0.72f, 0.32f}, 0.28f, 1.0f));
  MeshBuilder pedestal, ball, ring;
  pedestal.box({-1.55f, 0.0f, -1.15f}, {-0.65f, 0.55f, -0.25f});
  ball.ball({-1.1f, 1.0f, -0.7f}, 0.45f, 64);
  ring.ring({0, 0, 0}, 0.62f, 0.04f, 72, 14);
  builder.addObject("pedestal", {pedestal.build(white)});
  builder.addObject("ball", {ball.build(white)});
  const int turning = builder.addObject("ring", {ring.build(gold)});
  builder.scene().nodes[static_cast<std::size_t>(turning)].translation = {1.45f, 1.3f, -1.35f};
  builder.animateSpin(turning, kFogSeconds, 1);
  for (int i = 0; i < 5; ++i) {
    MeshBuilder rope;
    const float x = 2.1f + 0.3f * static_cast<float>(i);
    const std::array<glm::vec3, 2> ends{glm::vec3(x, 0.0f, -0.6f), glm::vec3(x - 1.1f, 5.6f, -0.9f)};
    rope.tube(ends, 0.012f, 8);
    builder.addObject("rope", {rope.build(hemp)});
  }
  for (int i = 0; i < 3; ++i) {
    MeshBuilder crate;
    const float x = -4.3f + 0.95f * static_cast<float>(i), height = i == 1 ? 1.5f : 0.8f;
    crate.box({x, 0.0f, -3.4f}, {x + 0.8f, height, -2.6f});
    builder.addObject("crate", {crate.build(white)});
  }
}

} // namespace

Scene makeFogScene() {
  SceneBuilder builder("builtin:fog");
  addHall(builder);
  addThings(builder);
  const int still = builder.addNode("still lamp's hook", {-2.7f, 4.3f, -0.9f});
  addFogLamp(builder, {"still lamp", {1.0f, 0.72f, 0.42f}, 60.0f, 0.16f, 5.2f, 1.15f}, still, glm::vec3(0.0f),
             {0.42f, -1.0f, 0.05f});
  const int hook = builder.addNode("sweeping lamp's hook", {1.6f, 4.2f, -1.6f});
  addFogLamp(builder, {"sweeping lamp", {0.35f, 0.6f, 1.0f}, 60.0f, 0.14f, 5.0f, 0.85f}, hook,
             glm::vec3(0.0f), {0.0f, -1.0f, 0.12f});
  builder.animateSwing(hook, kFogSeconds, 0.5f, 1);
  builder.addPointLight("work light", {3.5f, 3.6f, 3.5f}, {0.75f, 0.8f, 1.0f}, 2.5f);
  const glm::vec3 eye(0.0f, 1.75f, 6.2f);
  builder.addCamera("front", eye, {0.0f, 0.02f, -1.0f}, 0.72f);
  const int slide = builder.addCamera("slide", eye, {0.0f, 0.02f, -1.0f}, 0.72f);
  builder.animateLoop(
      slide, kFogSeconds, [&](float angle) { return eye + glm::vec3(0.8f * std::sin(angle), 0, 0); },
      [](float angle) { return glm::vec3(0.8f * std::cos(angle), 0, 0); });
  Scene& scene = builder.scene();
  scene.sky.zenith = {0.05f, 0.06f, 0.10f};
  scene.sky.horizon = {0.06f, 0.07f, 0.10f};
  scene.sky.ground = {0.04f, 0.035f, 0.03f};
  scene.sky.sunEnabled = false;
  scene.shot = {240, 60.0, "gltf:front", {}};
  return builder.finish();
}

} // namespace taa
