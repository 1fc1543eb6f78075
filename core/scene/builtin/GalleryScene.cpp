// builtin:gallery: one object for each source of motion, on a labelled pedestal.
#include "core/scene/Geometry.h"
#include "core/scene/builtin/BuiltinScenes.h"
#include "core/scene/builtin/Lettering.h"
#include "core/scene/builtin/ProceduralTextures.h"
#include "core/scene/builtin/SceneBuilder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace taa {

namespace {

constexpr float kStep = 1.15f;          ///< meters from pedestal to pedestal
constexpr float kPedestalHeight = 0.8f; ///< of a pedestal
constexpr int kCount = 7;

glm::vec3 pedestalTop(int index) {
  return {kStep * (static_cast<float>(index) - 0.5f * (kCount - 1)), kPedestalHeight, 0.0f};
}

void addPedestal(SceneBuilder& builder, int index, std::string_view label, int stone) {
  const glm::vec3 top = pedestalTop(index);
  MeshBuilder block, plate;
  block.box({top.x - 0.4f, 0.0f, -0.4f}, {top.x + 0.4f, kPedestalHeight, 0.4f}, 0.8f);
  plate.quad({top.x - 0.38f, 0.5f, 0.405f}, {0.76f, 0, 0}, {0, 0.19f, 0});
  SceneImage image = plainImage(std::string(label), 256, 64, {30, 32, 36});
  const int scale = label.size() > 7 ? 4 : 5;
  const int width = static_cast<int>(label.size()) * kLetterStep * scale - scale;
  paintText(image, (256 - width) / 2, (64 - 7 * scale) / 2, scale, label, {240, 232, 210});
  Material brass = paintOf(glm::vec3(1.0f), 0.6f);
  brass.baseColorTexture = textureSlot(builder.addImage(std::move(image)));
  builder.addObject("pedestal", {block.build(stone), plate.build(builder.addMaterial(brass))});
}

/// A striped tube that two joints bend, and the wave that moves them.
void addSkinned(SceneBuilder& builder, const glm::vec3& place, int material) {
  constexpr int kRings = 33;
  constexpr float kTall = 1.1f;
  std::vector<glm::vec3> points;
  for (int i = 0; i < kRings; ++i)
    points.emplace_back(0.0f, kTall * (1.0f - static_cast<float>(i) / (kRings - 1)), 0.0f);
  MeshBuilder mesh;
  mesh.tube(points, 0.12f, 24);
  Primitive tube = mesh.build(material);
  tube.influenceSets = 1;
  for (const Vertex& vertex : tube.vertices) {
    const float t = glm::clamp(vertex.position.y / kTall, 0.0f, 1.0f), upper = t * t * (3.0f - 2.0f * t);
    tube.influences.push_back({{0, 1, 0, 0}, {1.0f - upper, upper, 0, 0}});
  }
  Skin skin;
  const int foot = builder.addNode("foot", place);
  const int head = builder.addNode("head", {0.0f, 0.5f * kTall, 0.0f}, {1, 0, 0, 0}, foot);
  skin.joints = {foot, head};
  skin.inverseBinds = {glm::mat4(1.0f), glm::mat4(1.0f)};
  skin.inverseBinds[1][3] = glm::vec4(0.0f, -0.5f * kTall, 0.0f, 1.0f);
  builder.scene().skins.push_back(skin);
  builder.addObject("skinned", {std::move(tube)});
  builder.scene().nodes.back().skin = 0;
  builder.animateSwing(head, 4.0f, 0.9f, 2);
}

/// A ball between a cube and a spiked star.
void addMorph(SceneBuilder& builder, const glm::vec3& place, int material) {
  MeshBuilder mesh;
  mesh.ball({0.0f, 0.42f, 0.0f}, 0.36f, 40);
  Primitive ball = mesh.build(material);
  ball.targets.resize(2);
  for (const Vertex& vertex : ball.vertices) {
    const glm::vec3 d = vertex.normal;
    const float cube = 1.0f / std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    ball.targets[0].push_back({0.36f * 0.8f * (cube - 1.2f) * d, {}, {}});
    const float wave = std::cos(6.0f * std::atan2(d.z, d.x)) * (1.0f - d.y * d.y);
    ball.targets[1].push_back({0.14f * wave * d, {}, {}});
  }
  makeMorphNormals(ball);
  builder.addObject("morph", {std::move(ball)});
  Scene& scene = builder.scene();
  Node& node = scene.nodes.back();
  node.translation = place;
  node.firstWeight = static_cast<int>(scene.morphWeights.size());
  scene.morphWeights.insert(scene.morphWeights.end(), {1.0f, 0.0f});
  builder.animateWeights(static_cast<int>(scene.nodes.size()) - 1, {0.0f, 1.0f, 2.0f, 3.0f, 4.0f},
                         {1, 0, 0, 0, 0, 1, 0, 0, 1, 0});
}

/// A flag whose free end sways.
void addFlag(SceneBuilder& builder, const glm::vec3& place, int pole) {
  constexpr int kColumns = 25, kRows = 13;
  std::vector<glm::vec3> points;
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column)
      points.emplace_back(0.75f * static_cast<float>(column) / (kColumns - 1),
                          1.15f - 0.45f * static_cast<float>(row) / (kRows - 1), 0.0f);
  Material cloth = paintOf({0.75f, 0.12f, 0.1f}, 0.8f);
  cloth.doubleSided = true;
  cloth.wind = {0.12f, 9.0f, -kTurn, {0.0f, 0.1f, 1.0f}};
  MeshBuilder sheet, stick;
  sheet.sheet(points, kColumns);
  Primitive flag = sheet.build(builder.addMaterial(cloth));
  for (Vertex& vertex : flag.vertices) vertex.uv1 = {0.0f, vertex.position.x / 0.75f};
  const std::array<glm::vec3, 2> ends{{{0, 1.2f, 0}, {0, 0, 0}}};
  stick.tube(ends, 0.02f, 12);
  builder.addObject("wind", {std::move(flag), stick.build(pole)});
  builder.scene().nodes.back().translation = place - glm::vec3(0.3f, 0, 0);
}

/// A round sheet of water with rings, baked frame by frame with its velocities.
void addCache(SceneBuilder& builder, const glm::vec3& place, int material) {
  constexpr int kSide = 25, kFrames = 240;
  constexpr double kRate = 60.0;
  const auto height = [](float x, float z, int frame) {
    const float r = std::sqrt(x * x + z * z);
    return 0.1f * std::sin(14.0f * r - kTurn * static_cast<float>(frame) / 60.0f) * (1.0f - r);
  };
  std::vector<glm::vec3> points;
  for (int row = 0; row < kSide; ++row)
    for (int column = 0; column < kSide; ++column) {
      const float x = -0.38f + 0.76f * static_cast<float>(column) / (kSide - 1),
                  z = -0.38f + 0.76f * static_cast<float>(row) / (kSide - 1);
      points.emplace_back(x, 0.15f + height(x, z, 0), z);
    }
  MeshBuilder mesh;
  mesh.sheet(points, kSide);
  Primitive water = mesh.build(material);
  water.cache.frames = kFrames;
  water.cache.framesPerSecond = kRate;
  for (int frame = 0; frame < kFrames; ++frame)
    for (const Vertex& vertex : water.vertices) {
      const float x = vertex.position.x, z = vertex.position.z, e = 1e-3f;
      const glm::vec3 normal(height(x - e, z, frame) - height(x + e, z, frame), 2.0f * e,
                             height(x, z - e, frame) - height(x, z + e, frame));
      const float now = height(x, z, frame);
      water.cache.entries.push_back(
          {{x, 0.15f + now, z},
           glm::normalize(normal),
           {0.0f, static_cast<float>(kRate) * (now - height(x, z, frame - 1)), 0.0f}});
    }
  builder.addObject("cache", {std::move(water)});
  builder.scene().nodes.back().translation = place + glm::vec3(0, 0.1f, 0);
  builder.scene().nodes.back().rotation = glm::angleAxis(0.45f, glm::vec3(1, 0, 0)); // shown to the camera
}

/// One small mesh drawn by many nodes that circle together.
void addInstances(SceneBuilder& builder, const glm::vec3& place, int material) {
  const int ring = builder.addNode("instances", place + glm::vec3(0, 0.5f, 0));
  int first = -1;
  for (int i = 0; i < 12; ++i) {
    const float angle = kTurn * static_cast<float>(i) / 12.0f;
    const glm::vec3 at(0.33f * std::cos(angle), 0.33f * std::sin(angle), 0.0f);
    if (first < 0) {
      MeshBuilder mesh;
      mesh.box(glm::vec3(-0.06f), glm::vec3(0.06f));
      first = builder.addObject("instance", {mesh.build(material)}, ring);
      builder.scene().nodes.back().translation = at;
    } else {
      builder.addInstance(first, at);
    }
  }
  builder.animateSpin(ring, 4.0f, 1);
}

} // namespace

Scene makeGalleryScene() {
  SceneBuilder builder("builtin:gallery");
  SurfaceImages planks = plankImages(), bricks = brickImages();
  Material wall = paintOf(glm::vec3(1.0f), 0.85f), floor = paintOf(glm::vec3(1.0f), 0.3f);
  wall.baseColorTexture = textureSlot(builder.addImage(std::move(bricks.color)));
  wall.normalTexture = textureSlot(builder.addImage(std::move(bricks.normal)));
  floor.baseColorTexture = textureSlot(builder.addImage(tileImage()));
  MeshBuilder wallMesh, floorMesh;
  wallMesh.quad({-8.0f, 0.0f, -1.6f}, {16.0f, 0, 0}, {0, 4.5f, 0}, {12.0f, 3.4f});
  floorMesh.quad({-8.0f, 0.0f, 4.0f}, {16.0f, 0, 0}, {0, 0, -5.6f}, {12.0f, 4.2f});
  builder.addObject("wall", {wallMesh.build(builder.addMaterial(wall))});
  builder.addObject("floor", {floorMesh.build(builder.addMaterial(floor))});
  const int stone = builder.addMaterial(paintOf({0.55f, 0.53f, 0.5f}, 0.7f)),
            steel = builder.addMaterial(paintOf({0.75f, 0.77f, 0.8f}, 0.25f, 1.0f)),
            blue = builder.addMaterial(paintOf({0.08f, 0.3f, 0.75f}, 0.4f)),
            green = builder.addMaterial(paintOf({0.1f, 0.5f, 0.2f}, 0.45f)),
            gold = builder.addMaterial(paintOf({0.95f, 0.7f, 0.25f}, 0.3f, 1.0f));
  Material striped = paintOf(glm::vec3(1.0f), 0.6f);
  striped.baseColorTexture = textureSlot(builder.addImage(std::move(planks.color)));
  Material sea = paintOf({0.05f, 0.35f, 0.5f}, 0.15f);
  sea.doubleSided = true;
  constexpr std::array<std::string_view, kCount> kLabels{"CAMERA", "RIGID", "SKINNED",  "MORPH",
                                                         "WIND",   "CACHE", "INSTANCED"};
  for (int i = 0; i < kCount; ++i) addPedestal(builder, i, kLabels[static_cast<std::size_t>(i)], stone);
  MeshBuilder still, rigid;
  still.ball({0, 0.38f, 0}, 0.38f, 48);
  builder.addObject("camera", {still.build(steel)});
  builder.scene().nodes.back().translation = pedestalTop(0);
  rigid.box({-0.42f, -0.1f, -0.1f}, {0.42f, 0.1f, 0.1f});
  rigid.box({-0.1f, -0.42f, -0.1f}, {0.1f, 0.42f, 0.1f});
  const int cross = builder.addObject("rigid", {rigid.build(blue)});
  builder.scene().nodes.back().translation = pedestalTop(1) + glm::vec3(0, 0.55f, 0);
  builder.animateSpin(cross, 4.0f, 2);
  addSkinned(builder, pedestalTop(2), builder.addMaterial(striped));
  addMorph(builder, pedestalTop(3), green);
  addFlag(builder, pedestalTop(4), steel);
  addCache(builder, pedestalTop(5), builder.addMaterial(sea));
  addInstances(builder, pedestalTop(6), gold);
  const glm::vec3 eye(0.0f, 1.6f, 7.0f);
  const int camera = builder.addCamera("visit", eye, {0.0f, -0.07f, -1.0f}, 0.72f);
  builder.animateLoop(
      camera, 4.0f, [&](float angle) { return eye + glm::vec3(0.25f * std::sin(angle), 0, 0); },
      [](float angle) { return glm::vec3(0.25f * std::cos(angle), 0, 0); });
  Scene& scene = builder.scene();
  scene.sky.sunDirection = {-0.45f, 0.75f, 0.8f};
  scene.shot = {240, 60.0, "gltf:visit", {}};
  return builder.finish();
}

} // namespace taa
