// builtin:fan: a table fan at full speed in its wire guard, before bricks, a test chart and a string of
// lights.
#include "core/scene/builtin/BuiltinScenes.h"
#include "core/scene/builtin/ProceduralTextures.h"
#include "core/scene/builtin/SceneBuilder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace taa {

namespace {

constexpr float kFanSeconds = 4.0f;
constexpr int kFanTurns = 4;          ///< in the loop: 6° a frame at 60 Hz, 25 px at a blade's tip at 720p
constexpr float kBladeLength = 1.13f; ///< meters from the axis
constexpr float kGuardRadius = 1.24f, kTableHeight = -1.42f, kWall = -0.85f;

glm::vec3 around(float radius, float angle, float z) {
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

/// How far the guard bulges forward at `radius`.
float guardDepth(float radius) {
  return 0.26f * std::sqrt(std::max(0.0f, 1.0f - std::pow(radius / kGuardRadius, 6.0f)));
}

Material glowOf(const glm::vec3& radiance) {
  Material material = paintOf(glm::vec3(0.02f), 0.6f);
  material.emissive = radiance;
  return material;
}

/// A slender blade along +x at `angle`, twisted like a propeller's.
void addBlade(MeshBuilder& mesh, float angle) {
  constexpr int kAlong = 14, kAcross = 5;
  std::vector<glm::vec3> points;
  for (int j = 0; j < kAcross; ++j)
    for (int i = 0; i < kAlong; ++i) {
      const float s = static_cast<float>(i) / (kAlong - 1), t = static_cast<float>(j) / (kAcross - 1) - 0.5f;
      const float radius = 0.14f + s * (kBladeLength - 0.14f);
      const float chord = (0.07f + 0.17f * std::sin(2.6f * s)) * std::sqrt(1.0f - 0.6f * s * s * s * s);
      const float pitch = 0.75f - 0.45f * s; // radians: steep at the hub
      const float sweep = -0.22f * s * s;
      points.push_back(around(radius, angle + sweep - t * chord * std::cos(pitch) / radius,
                              -t * chord * std::sin(pitch) + 0.05f * (t * t - 0.25f)));
    }
  mesh.sheet(points, kAlong);
}

void addFanRotor(SceneBuilder& builder) {
  Material cream = paintOf({0.86f, 0.82f, 0.72f}, 0.35f), coral = paintOf({0.80f, 0.19f, 0.08f}, 0.35f);
  cream.doubleSided = coral.doubleSided = true;
  const int creamId = builder.addMaterial(cream), coralId = builder.addMaterial(coral);
  const int brass = builder.addMaterial(paintOf({0.90f, 0.66f, 0.30f}, 0.22f, 1.0f));
  const int glow = builder.addMaterial(glowOf({26.0f, 13.0f, 0.8f}));
  constexpr int kBlades = 7;
  MeshBuilder creamBlades, coralBlades, hub, beads;
  for (int blade = 0; blade < kBlades; ++blade) {
    const float angle = kTurn * static_cast<float>(blade) / kBlades;
    addBlade(blade % 3 == 0 ? coralBlades : creamBlades, angle);
    beads.ball(around(kBladeLength - 0.03f, angle - 0.22f, 0.02f), 0.014f, 10);
  }
  constexpr std::array<glm::vec2, 6> kHub{
      {{0.0f, 0.16f}, {0.07f, 0.15f}, {0.13f, 0.11f}, {0.17f, 0.03f}, {0.17f, -0.10f}, {0.0f, -0.10f}}};
  hub.lathe(glm::vec3(0.0f), kHub, 40);
  const int rotor = builder.addObject(
      "rotor", {creamBlades.build(creamId), coralBlades.build(coralId), hub.build(brass), beads.build(glow)});
  builder.animateSpin(rotor, kFanSeconds, kFanTurns);
}

/// The cage: rings and spokes of wire, about one pixel thick at 720p.
void addGuard(SceneBuilder& builder) {
  const int chrome = builder.addMaterial(paintOf({0.80f, 0.82f, 0.85f}, 0.25f, 1.0f));
  constexpr int kSpokes = 36;
  constexpr float kWire = 0.0045f;
  MeshBuilder wires;
  for (const float side : {1.0f, -1.0f}) {
    for (const float radius : {0.22f, 0.62f, 0.95f})
      wires.ring({0.0f, 0.0f, side * guardDepth(radius)}, radius, kWire, 72, 5);
    for (int spoke = 0; spoke < kSpokes; ++spoke) {
      const float angle = kTurn * (static_cast<float>(spoke) + (side > 0 ? 0.0f : 0.5f)) / kSpokes;
      std::vector<glm::vec3> points;
      for (const float radius : {0.22f, 0.55f, 0.85f, 1.08f, 1.20f, kGuardRadius})
        points.push_back(around(radius, angle + 0.35f * (radius - 0.22f), side * guardDepth(radius)));
      wires.tube(points, kWire, 5);
    }
  }
  wires.ring(glm::vec3(0.0f), kGuardRadius, 0.018f, 96, 10);
  constexpr std::array<glm::vec2, 4> kCap{
      {{0.0f, 0.285f}, {0.19f, 0.275f}, {0.225f, 0.25f}, {0.225f, 0.235f}}};
  wires.lathe(glm::vec3(0.0f), kCap, 48);
  builder.addObject("guard", {wires.build(chrome)});
}

void addStand(SceneBuilder& builder) {
  const int enamel = builder.addMaterial(paintOf({0.10f, 0.24f, 0.27f}, 0.3f));
  MeshBuilder stand;
  constexpr std::array<glm::vec2, 5> kMotor{
      {{0.20f, -0.12f}, {0.24f, -0.2f}, {0.22f, -0.45f}, {0.12f, -0.55f}, {0.0f, -0.56f}}};
  stand.lathe(glm::vec3(0.0f), kMotor, 40);
  const std::array<glm::vec3, 2> pole{{{0.0f, -0.15f, -0.38f}, {0.0f, kTableHeight, -0.38f}}};
  stand.tube(pole, 0.05f, 20);
  for (int step = 0; step < 3; ++step) {
    const float half = 0.62f - 0.07f * static_cast<float>(step),
                y = kTableHeight + 0.03f * static_cast<float>(step);
    stand.box({-half, y, -0.38f - 0.5f * half}, {half, y + 0.03f, -0.38f + 0.8f * half});
  }
  builder.addObject("stand", {stand.build(enamel)});
}

void addRoom(SceneBuilder& builder) {
  SurfaceImages bricks = brickImages();
  Material wall = paintOf(glm::vec3(1.0f), 0.85f), table = paintOf(glm::vec3(1.0f), 0.35f),
           chart = paintOf(glm::vec3(1.0f), 0.6f);
  wall.baseColorTexture = textureSlot(builder.addImage(std::move(bricks.color)));
  wall.normalTexture = textureSlot(builder.addImage(std::move(bricks.normal)));
  table.baseColorTexture = textureSlot(builder.addImage(tileImage()));
  chart.baseColorTexture = textureSlot(builder.addImage(posterImage()));
  MeshBuilder wallMesh, tableMesh, chartMesh;
  wallMesh.quad({-4.5f, kTableHeight, kWall}, {9.0f, 0, 0}, {0, 4.2f, 0}, {7.5f, 3.5f});
  tableMesh.quad({-4.5f, kTableHeight, 2.2f}, {9.0f, 0, 0}, {0, 0, kWall - 2.2f}, {7.5f, 2.54f});
  chartMesh.quad({-2.35f, -0.75f, kWall + 0.02f}, {1.35f, 0, 0}, {0, kPosterAspect * 1.35f, 0});
  builder.addObject("wall", {wallMesh.build(builder.addMaterial(wall))});
  builder.addObject("table", {tableMesh.build(builder.addMaterial(table))});
  builder.addObject("chart", {chartMesh.build(builder.addMaterial(chart))});
}

/// A cable across the wall with small, very bright bulbs: fireflies for the resolve.
void addLights(SceneBuilder& builder) {
  const int rubber = builder.addMaterial(paintOf({0.03f, 0.035f, 0.03f}, 0.6f));
  const std::array<int, 3> glow{builder.addMaterial(glowOf({30.0f, 10.0f, 0.7f})),
                                builder.addMaterial(glowOf({22.0f, 0.8f, 0.5f})),
                                builder.addMaterial(glowOf({0.3f, 9.0f, 16.0f}))};
  std::array<MeshBuilder, 3> bulbs;
  MeshBuilder cable;
  std::vector<glm::vec3> points;
  constexpr int kPoints = 97;
  for (int i = 0; i < kPoints; ++i) {
    const float x = -3.6f + 7.2f * static_cast<float>(i) / (kPoints - 1);
    const float swag = std::abs(std::sin(1.309f * (x + 3.6f))); // hung every 2.4 m
    points.emplace_back(x, 1.52f - 0.34f * swag, kWall + 0.06f);
    if (i % 4 == 2)
      bulbs[static_cast<std::size_t>(i / 4 % 3)].ball(points.back() - glm::vec3(0, 0.035f, 0), 0.02f, 12);
  }
  cable.tube(points, 0.007f, 6);
  builder.addObject("cable", {cable.build(rubber)});
  builder.addObject("bulbs", {bulbs[0].build(glow[0]), bulbs[1].build(glow[1]), bulbs[2].build(glow[2])});
  builder.addPointLight("warm", {-2.0f, 1.25f, kWall + 0.55f}, {1.0f, 0.66f, 0.36f}, 1.9f);
  builder.addPointLight("amber", {1.1f, 1.3f, kWall + 0.5f}, {1.0f, 0.6f, 0.3f}, 1.5f);
  builder.addPointLight("teal", {2.9f, -0.4f, 0.5f}, {0.25f, 0.75f, 0.9f}, 2.4f);
}

/// Polished and glowing things on the table.
void addOrnaments(SceneBuilder& builder) {
  const int mirror = builder.addMaterial(paintOf({0.93f, 0.93f, 0.95f}, 0.08f, 1.0f));
  const int copper = builder.addMaterial(paintOf({0.95f, 0.55f, 0.38f}, 0.3f, 1.0f));
  const int lamp = builder.addMaterial(glowOf({1.6f, 0.95f, 0.5f}));
  MeshBuilder left, right, globe, beads;
  left.ball({-1.62f, kTableHeight + 0.27f, 0.15f}, 0.27f, 48);
  right.ball({1.42f, kTableHeight + 0.17f, 0.45f}, 0.17f, 40);
  globe.ball({1.95f, kTableHeight + 0.24f, -0.1f}, 0.24f, 48);
  for (int i = 0; i < 15; ++i)
    beads.ball({-1.05f + 0.15f * static_cast<float>(i), kTableHeight + 0.022f,
                0.75f + 0.07f * std::sin(1.9f * static_cast<float>(i))},
               0.022f, 12);
  builder.addObject("mirror ball", {left.build(mirror)});
  builder.addObject("copper ball", {right.build(copper)});
  builder.addObject("globe lamp", {globe.build(lamp)});
  builder.addObject("beads", {beads.build(copper)});
}

} // namespace

Scene makeFanScene() {
  SceneBuilder builder("builtin:fan");
  addRoom(builder);
  addStand(builder);
  addFanRotor(builder);
  addGuard(builder);
  addLights(builder);
  addOrnaments(builder);
  const glm::vec3 eye(0.0f, 0.30f, 4.35f);
  const int camera = builder.addCamera("front", eye, {0.0f, -0.075f, -1.0f}, 0.70f);
  builder.animateLoop(
      camera, kFanSeconds,
      [&](float angle) { return eye + glm::vec3(0.28f * std::sin(angle), 0.05f * std::cos(angle), 0.0f); },
      [&](float angle) { return glm::vec3(0.28f * std::cos(angle), -0.05f * std::sin(angle), 0.0f); });
  Scene& scene = builder.scene();
  scene.sky.zenith = {0.16f, 0.19f, 0.27f};
  scene.sky.horizon = {0.42f, 0.36f, 0.31f};
  scene.sky.ground = {0.15f, 0.12f, 0.10f};
  scene.sky.sunDirection = {-0.55f, 0.75f, 0.8f};
  scene.sky.sunColor = {1.7f, 1.5f, 1.3f};
  scene.shot = {240, 60.0, "gltf:front", {}};
  return builder.finish();
}

} // namespace taa
