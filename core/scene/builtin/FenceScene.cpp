// builtin:fence: a camera passes pickets, barbed wire, a net and power lines that run from close by to the
// horizon.
#include "core/scene/builtin/BuiltinScenes.h"
#include "core/scene/builtin/ProceduralTextures.h"
#include "core/scene/builtin/SceneBuilder.h"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace taa {

namespace {

constexpr float kFenceSeconds = 4.0f;
constexpr float kPanel = 2.4f; ///< meters, length of a section of fence
constexpr int kPanels = 26;
constexpr float kFenceX =
    1.5f; ///< the picket fence runs along −z at this x, the wire fence on the other side

/// A hanging wire from `from` to `to`, `sag` meters deep in the middle.
void addWire(MeshBuilder& mesh, const glm::vec3& from, const glm::vec3& to, float sag, float radius) {
  constexpr int kPoints = 13;
  std::vector<glm::vec3> points;
  for (int i = 0; i < kPoints; ++i) {
    const float t = static_cast<float>(i) / (kPoints - 1);
    points.push_back(from + t * (to - from) - glm::vec3(0, sag * 4.0f * t * (1.0f - t), 0));
  }
  mesh.tube(points, radius, 5);
}

/// One picket standing at the origin's `z`: a board along z with a pointed top, thin across x.
void addPicket(MeshBuilder& mesh, float z) {
  constexpr float kHalf = 0.045f, kThin = 0.011f, kShoulder = 1.0f, kTip = 1.09f;
  mesh.box({-kThin, 0.06f, z - kHalf}, {kThin, kShoulder, z + kHalf}, 1.4f);
  for (const float side : {-1.0f, 1.0f}) { // the roof's two slopes and, on both faces, its gable
    const glm::vec3 shoulder(-kThin, kShoulder, z + side * kHalf), tip(-kThin, kTip, z);
    const glm::vec3 across(2.0f * kThin, 0, 0), slope = tip - shoulder;
    if (side < 0)
      mesh.quad(shoulder, slope, across);
    else
      mesh.quad(shoulder, across, slope);
  }
  for (const float side : {-1.0f, 1.0f}) {
    mesh.face({side * kThin, kTip, z}, {side * kThin, kShoulder, z + side * kHalf},
              {side * kThin, kShoulder, z - side * kHalf}, 1.4f);
  }
}

void addPicketFence(SceneBuilder& builder) {
  SurfaceImages planks = plankImages();
  Material white = paintOf({0.95f, 0.94f, 0.90f}, 0.6f);
  white.baseColorTexture = textureSlot(builder.addImage(std::move(planks.color)));
  white.normalTexture = textureSlot(builder.addImage(std::move(planks.normal)));
  MeshBuilder panel;
  constexpr int kPickets = 16;
  for (int i = 0; i < kPickets; ++i) addPicket(panel, -kPanel * (static_cast<float>(i) + 0.5f) / kPickets);
  for (const float y : {0.28f, 0.78f}) panel.box({0.011f, y, -kPanel}, {0.045f, y + 0.07f, 0.0f}, 1.4f);
  panel.box({0.02f, 0.0f, -0.05f}, {0.12f, 0.96f, 0.05f}, 1.4f);
  const int first = builder.addObject("pickets", {panel.build(builder.addMaterial(white))});
  builder.scene().nodes.back().translation = {kFenceX, 0.0f, 3.0f};
  for (int i = 1; i < kPanels; ++i)
    builder.addInstance(first, {kFenceX, 0.0f, 3.0f - kPanel * static_cast<float>(i)});
}

/// Posts with five wires of 6 mm: a pixel wide near by, a tenth of one at the far end.
void addWireFence(SceneBuilder& builder) {
  const int wood = builder.addMaterial(paintOf({0.23f, 0.16f, 0.10f}, 0.9f));
  const int steel = builder.addMaterial(paintOf({0.62f, 0.64f, 0.66f}, 0.35f, 1.0f));
  MeshBuilder posts, wires;
  const std::array<glm::vec3, 2> post{{{0, 1.3f, 0}, {0, 0, 0}}};
  posts.tube(post, 0.05f, 12);
  for (int wire = 0; wire < 5; ++wire) {
    const float y = 0.25f + 0.23f * static_cast<float>(wire);
    addWire(wires, {0, y, 0}, {0, y, -kPanel}, 0.015f, 0.003f);
    for (int barb = 1; barb < 10; ++barb) {
      const float t = static_cast<float>(barb) / 10, z = -kPanel * t;
      const glm::vec3 knot(0.0f, y - 0.06f * t * (1.0f - t), z);
      const std::array<glm::vec3, 2> spike{knot - glm::vec3(0.02f, 0.02f, 0),
                                           knot + glm::vec3(0.02f, 0.02f, 0)};
      wires.tube(spike, 0.002f, 3);
    }
  }
  const int first = builder.addObject("wires", {posts.build(wood), wires.build(steel)});
  builder.scene().nodes.back().translation = {-kFenceX, 0.0f, 3.0f};
  for (int i = 1; i < kPanels; ++i)
    builder.addInstance(first, {-kFenceX, 0.0f, 3.0f - kPanel * static_cast<float>(i)});
}

/// Panels of chain link cut out by alpha, across the end of the path.
void addNet(SceneBuilder& builder) {
  Material net = paintOf({0.75f, 0.8f, 0.78f}, 0.4f);
  net.baseColorTexture = textureSlot(builder.addImage(netImage()));
  net.alphaMode = AlphaMode::Mask;
  net.alphaCutoff = 0.4f;
  net.doubleSided = true;
  MeshBuilder mesh, frame;
  mesh.quad({2.4f, 0.05f, -7.5f}, {8.0f, 0, 0}, {0, 2.2f, 0}, {16.0f, 4.4f});
  for (int i = 0; i < 5; ++i) {
    const float x = 2.4f + 2.0f * static_cast<float>(i);
    const std::array<glm::vec3, 2> pole{{{x, 2.3f, -7.5f}, {x, 0.0f, -7.5f}}};
    frame.tube(pole, 0.03f, 12);
  }
  const int steel = builder.addMaterial(paintOf({0.55f, 0.58f, 0.60f}, 0.4f, 1.0f));
  builder.addObject("net", {mesh.build(builder.addMaterial(net)), frame.build(steel)});
}

/// Masts with crossbars and four thin lines, seen against the sky.
void addPowerLine(SceneBuilder& builder) {
  constexpr float kSpan = 16.0f, kX = -6.0f;
  const int timber = builder.addMaterial(paintOf({0.17f, 0.13f, 0.10f}, 0.9f));
  const int cable = builder.addMaterial(paintOf({0.05f, 0.05f, 0.055f}, 0.5f));
  MeshBuilder mast, lines;
  const std::array<glm::vec3, 2> pole{{{0, 6.4f, 0}, {0, 0, 0}}};
  mast.tube(pole, 0.11f, 14);
  mast.box({-1.0f, 5.9f, -0.06f}, {1.0f, 6.05f, 0.06f});
  mast.box({-0.7f, 5.2f, -0.06f}, {0.7f, 5.35f, 0.06f});
  constexpr std::array<glm::vec2, 4> kEnds{{{-0.95f, 6.1f}, {0.95f, 6.1f}, {-0.65f, 5.4f}, {0.65f, 5.4f}}};
  for (const glm::vec2& end : kEnds) addWire(lines, {end, 0.0f}, {end, -kSpan}, 0.7f, 0.012f);
  const int first = builder.addObject("power line", {mast.build(timber), lines.build(cable)});
  builder.scene().nodes.back().translation = {kX, 0.0f, 8.0f};
  for (int i = 1; i < 6; ++i) builder.addInstance(first, {kX, 0.0f, 8.0f - kSpan * static_cast<float>(i)});
}

/// Ground and path.
void addLand(SceneBuilder& builder) {
  Material grass = paintOf(glm::vec3(1.0f), 0.95f), path = paintOf(glm::vec3(1.0f), 0.95f);
  grass.baseColorTexture = textureSlot(builder.addImage(grassImage()));
  path.baseColorTexture = textureSlot(builder.addImage(gravelImage()));
  MeshBuilder land, track;
  land.quad({-60.0f, 0.0f, 12.0f}, {120.0f, 0, 0}, {0, 0, -112.0f}, {48.0f, 44.8f});
  track.quad({-0.9f, 0.01f, 12.0f}, {1.8f, 0, 0}, {0, 0, -90.0f}, {0.9f, 45.0f});
  builder.addObject("land", {land.build(builder.addMaterial(grass))});
  builder.addObject("path", {track.build(builder.addMaterial(path))});
}

/// Round trees, some behind the barn and a row along the horizon.
void addTrees(SceneBuilder& builder) {
  const int bark = builder.addMaterial(paintOf({0.16f, 0.11f, 0.07f}, 0.95f));
  const int leaves = builder.addMaterial(paintOf({0.10f, 0.19f, 0.045f}, 0.9f));
  MeshBuilder trunk, crown;
  const std::array<glm::vec3, 2> stem{{{0, 2.2f, 0}, {0, 0, 0}}};
  trunk.tube(stem, 0.16f, 8);
  constexpr std::array<glm::vec4, 5> kBalls{{{0.0f, 3.1f, 0.0f, 1.35f},
                                             {0.9f, 2.6f, 0.3f, 0.95f},
                                             {-0.85f, 2.7f, 0.4f, 0.9f},
                                             {0.2f, 2.5f, -0.9f, 0.95f},
                                             {-0.1f, 4.0f, 0.1f, 0.85f}}};
  for (const glm::vec4& ball : kBalls) crown.ball(glm::vec3(ball), ball.w, 14);
  const int first = builder.addObject("tree", {trunk.build(bark), crown.build(leaves)});
  builder.scene().nodes.back().translation = {15.5f, 0.0f, -27.0f};
  constexpr std::array<glm::vec3, 11> kPlaces{{{3.0f, 0.0f, -36.0f},
                                               {18.5f, 0.0f, -33.0f},
                                               {-14.0f, 0.0f, -30.0f},
                                               {-19.0f, 0.0f, -41.0f},
                                               {-11.0f, 0.0f, -52.0f},
                                               {-27.0f, 0.0f, -60.0f},
                                               {-3.5f, 0.0f, -70.0f},
                                               {6.0f, 0.0f, -74.0f},
                                               {16.0f, 0.0f, -66.0f},
                                               {27.0f, 0.0f, -58.0f},
                                               {36.0f, 0.0f, -72.0f}}};
  for (std::size_t i = 0; i < kPlaces.size(); ++i)
    builder.addInstance(first, kPlaces[i], glm::vec3(0.8f + 0.13f * static_cast<float>(i * 5 % 7)));
}

void addBarn(SceneBuilder& builder) {
  Material red = paintOf({0.55f, 0.09f, 0.06f}, 0.8f);
  const Material& boards = builder.scene().materials.front(); // the pickets' planks, painted red
  red.baseColorTexture = boards.baseColorTexture;
  red.normalTexture = boards.normalTexture;
  Material window = paintOf(glm::vec3(0.02f), 0.4f);
  window.emissive = {7.0f, 2.6f, 0.5f};
  const int redId = builder.addMaterial(red), slate = [&] {
    Material material = paintOf({0.12f, 0.13f, 0.16f}, 0.7f);
    material.doubleSided = true; // the eaves are seen from below
    return builder.addMaterial(material);
  }();
  MeshBuilder walls, roof, windows;
  walls.box({5.0f, 0.0f, -30.0f}, {13.0f, 3.4f, -20.0f}, 0.4f);
  const glm::vec3 ridge(9.0f, 5.9f, -19.6f), back(0, 0, -10.8f);
  roof.quad({4.6f, 3.2f, -19.6f}, ridge - glm::vec3(4.6f, 3.2f, -19.6f), back);
  roof.quad(ridge, glm::vec3(13.4f, 3.2f, -19.6f) - ridge, back);
  walls.face({9.0f, 5.75f, -20.0f}, {5.0f, 3.4f, -20.0f}, {13.0f, 3.4f, -20.0f}, 0.4f);
  for (int i = 0; i < 4; ++i)
    windows.quad({5.7f + 1.8f * static_cast<float>(i), 1.5f, -19.98f}, {0.8f, 0, 0}, {0, 1.0f, 0});
  builder.addObject("barn",
                    {walls.build(redId), roof.build(slate), windows.build(builder.addMaterial(window))});
}

} // namespace

Scene makeFenceScene() {
  SceneBuilder builder("builtin:fence");
  addPicketFence(builder);
  addWireFence(builder);
  addNet(builder);
  addPowerLine(builder);
  addLand(builder);
  addBarn(builder);
  addTrees(builder);
  const glm::vec3 eye(0.0f, 1.25f, 4.2f);
  const int camera = builder.addCamera("pass", eye, {0.16f, -0.03f, -1.0f}, 0.80f);
  const auto swing = [](float angle) { return 0.55f * std::sin(angle); };
  builder.animateLoop(
      camera, kFenceSeconds, [&](float angle) { return eye + glm::vec3(swing(angle), 0, 0); },
      [&](float angle) { return glm::vec3(swing(angle + 0.25f * kTurn), 0, 0); });
  Scene& scene = builder.scene();
  scene.sky.sunDirection = {-0.6f, 0.5f, 0.55f};
  scene.sky.sunColor = {3.2f, 2.75f, 2.2f};
  scene.sky.shadowed = {{-9.0f, 0.0f, -14.0f}, {14.0f, 5.0f, 5.0f}}; // not of the land to its end
  scene.shot = {240, 60.0, "gltf:pass", {}};
  return builder.finish();
}

} // namespace taa
