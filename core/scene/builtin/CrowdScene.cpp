// builtin:crowd: six hundred things of a few meshes, a million triangles in all, most of them small and far.
#include "core/scene/builtin/BuiltinScenes.h"
#include "core/scene/builtin/ProceduralTextures.h"
#include "core/scene/builtin/SceneBuilder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace taa {

namespace {

constexpr float kCrowdSeconds = 4.0f; // of the loop
constexpr int kCrowdRows = 26, kCrowdColumns = 24;
constexpr float kSpacing = 1.35f; // meters
/// Takes z, around which lathes, rings and spins go, to the vertical.
const glm::quat kUpright(std::sqrt(0.5f), -std::sqrt(0.5f), 0.0f, 0.0f);

/// The meshes there are, into Scene::meshes.
struct Figures {
  std::array<int, 3> pegs{}; ///< upright, of different colors
  int hoops = 0;             ///< upright
  int ball = 0;              ///< upright; spins
  int pole = 0, rotor = 0;   ///< the rotor spins on the pole
  int lantern = 0;
  int board = 0;
};

int addMesh(SceneBuilder& builder, const std::string& name, std::vector<Primitive> primitives) {
  std::vector<Mesh>& meshes = builder.scene().meshes;
  meshes.push_back({name, std::move(primitives)});
  return static_cast<int>(meshes.size()) - 1;
}

/// Somebody like the pieces of a board game, 1.2 m high.
int addPeg(SceneBuilder& builder, const std::string& name, const glm::vec3& color) {
  constexpr int kSteps = 18;
  std::vector<glm::vec2> profile; // radius and height, from the top down
  for (int step = 0; step <= kSteps; ++step) {
    const float down = static_cast<float>(step) / kSteps;
    const float head = 0.17f * std::sqrt(std::max(0.0f, 1.0f - std::pow(down * 3.6f - 1.0f, 2.0f)));
    const float body = 0.08f + 0.26f * std::pow(std::max(0.0f, down - 0.35f), 1.5f);
    profile.emplace_back(std::max(head, down > 0.4f ? body : 0.001f), 1.2f * (1.0f - down));
  }
  MeshBuilder peg;
  peg.lathe(glm::vec3(0.0f), profile, 64);
  return addMesh(builder, name, {peg.build(builder.addMaterial(paintOf(color, 0.45f)))});
}

int addHoops(SceneBuilder& builder) {
  MeshBuilder hoops;
  for (int i = 0; i < 4; ++i)
    hoops.ring({0, 0, 0.15f + 0.3f * static_cast<float>(i)}, 0.4f - 0.08f * static_cast<float>(i), 0.012f, 48,
               8);
  return addMesh(builder, "hoops",
                 {hoops.build(builder.addMaterial(paintOf({0.9f, 0.75f, 0.5f}, 0.3f, 1.0f)))});
}

/// A silhouette and spokes a centimeter thick, which soon are thinner than a pixel.
int addCrowdRotor(SceneBuilder& builder) {
  constexpr int kSpokes = 16;
  MeshBuilder rotor;
  rotor.ring(glm::vec3(0.0f), 0.45f, 0.012f, 96, 10);
  for (int spoke = 0; spoke < kSpokes; ++spoke) {
    const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(spoke) / kSpokes;
    const std::array<glm::vec3, 2> line{glm::vec3(0.0f),
                                        0.45f * glm::vec3(std::cos(angle), std::sin(angle), 0.0f)};
    rotor.tube(line, 0.006f, 8);
  }
  return addMesh(builder, "rotor", {rotor.build(builder.addMaterial(paintOf({0.95f, 0.93f, 0.9f}, 0.4f)))});
}

int addPole(SceneBuilder& builder, int material) {
  const std::array<glm::vec3, 2> line{glm::vec3(0.0f), glm::vec3(0, 1.3f, 0)};
  MeshBuilder pole;
  pole.tube(line, 0.015f, 12);
  return addMesh(builder, "pole", {pole.build(material)});
}

/// Far ones are sparks smaller than a pixel, brighter than white.
int addLantern(SceneBuilder& builder, int metal) {
  const std::array<glm::vec3, 2> line{glm::vec3(0.0f), glm::vec3(0, 1.5f, 0)};
  MeshBuilder pole, globe;
  pole.tube(line, 0.02f, 12);
  globe.ball({0, 1.55f, 0}, 0.05f, 40);
  Material glow = paintOf(glm::vec3(0.02f), 0.6f);
  glow.emissive = {30.0f, 20.0f, 9.0f};
  return addMesh(builder, "lantern", {pole.build(metal), globe.build(builder.addMaterial(glow))});
}

/// A test chart behind bars: two patterns finer than a pixel that cross.
int addPoster(SceneBuilder& builder, int metal) {
  constexpr int kBars = 24;
  constexpr float kWidth = 0.9f, kHeight = kWidth * kPosterAspect;
  Material chart = paintOf(glm::vec3(1.0f), 0.9f);
  chart.baseColorTexture = textureSlot(builder.addImage(posterImage()));
  MeshBuilder picture, bars;
  picture.quad({-0.5f * kWidth, 0.1f, 0.0f}, {kWidth, 0, 0}, {0, kHeight, 0});
  picture.quad({0.5f * kWidth, 0.1f, -0.01f}, {-kWidth, 0, 0}, {0, kHeight, 0});
  for (int bar = 0; bar < kBars; ++bar) {
    const float x = kWidth * ((static_cast<float>(bar) + 0.5f) / kBars - 0.5f);
    bars.box({x - 0.006f, 0.05f, 0.08f}, {x + 0.006f, 0.2f + kHeight, 0.092f});
  }
  return addMesh(builder, "board", {picture.build(builder.addMaterial(chart)), bars.build(metal)});
}

Figures addFigures(SceneBuilder& builder) {
  const int metal = builder.addMaterial(paintOf({0.2f, 0.21f, 0.23f}, 0.4f, 1.0f));
  Material tile = paintOf(glm::vec3(1.0f), 0.35f);
  tile.baseColorTexture = textureSlot(builder.addImage(tileImage()));
  Figures figures;
  figures.pegs = {addPeg(builder, "red peg", {0.6f, 0.08f, 0.06f}),
                  addPeg(builder, "white peg", {0.85f, 0.83f, 0.78f}),
                  addPeg(builder, "blue peg", {0.05f, 0.1f, 0.35f})};
  figures.hoops = addHoops(builder);
  figures.pole = addPole(builder, metal);
  figures.rotor = addCrowdRotor(builder);
  figures.lantern = addLantern(builder, metal);
  figures.board = addPoster(builder, metal);
  MeshBuilder ball;
  ball.ball({0, 0, 0.45f}, 0.42f, 56);
  figures.ball = addMesh(builder, "ball", {ball.build(builder.addMaterial(tile))});
  MeshBuilder ground;
  ground.quad({-40.0f, 0.0f, 12.0f}, {80.0f, 0, 0}, {0, 0, -72.0f}, {80.0f, 72.0f});
  builder.addObject("ground", {ground.build(builder.addMaterial(tile))});
  return figures;
}

int place(SceneBuilder& builder, const std::string& name, int mesh, const glm::vec3& at, int parent,
          const glm::quat& rotation = {1, 0, 0, 0}) {
  const int node = builder.addNode(name, at, rotation, parent);
  builder.scene().nodes.back().mesh = mesh;
  return node;
}

/// The one at `column` of the row that the node `row` carries.
void addFigure(SceneBuilder& builder, const Figures& figures, int kind, const std::string& name,
               const glm::vec3& at, int row) {
  switch (kind) {
  case 3:
    place(builder, "hoops" + name, figures.hoops, at, row, kUpright);
    return;
  case 4: {
    place(builder, "pole" + name, figures.pole, at, row);
    const int rotor = place(builder, "rotor" + name, figures.rotor, at + glm::vec3(0, 1.3f, 0.03f), row);
    builder.animateSpin(rotor, kCrowdSeconds, 2 + static_cast<int>(builder.scene().nodes.size() % 3) * 2);
    return;
  }
  case 5:
    place(builder, "lantern" + name, figures.lantern, at, row);
    return;
  case 6:
    place(builder, "board" + name, figures.board, at, row);
    return;
  case 7: {
    const int stand = builder.addNode("stand" + name, at, kUpright, row);
    builder.animateSpin(place(builder, "ball" + name, figures.ball, glm::vec3(0.0f), stand), kCrowdSeconds,
                        2);
    return;
  }
  default:
    place(builder, "peg" + name, figures.pegs[static_cast<std::size_t>(kind)], at, row, kUpright);
  }
}

/// Rows behind each other; every third one walks to and fro, and its neighbors are uncovered behind it.
void addCrowdRows(SceneBuilder& builder, const Figures& figures) {
  for (int row = 0; row < kCrowdRows; ++row) {
    const glm::vec3 at(0.0f, 0.0f, -kSpacing * static_cast<float>(row));
    const int carrier = builder.addNode("row " + std::to_string(row), at);
    if (row % 3 == 1) {
      const float width = row % 2 == 0 ? 0.9f : -1.4f;
      builder.animateLoop(
          carrier, kCrowdSeconds, [&](float angle) { return at + glm::vec3(width * std::sin(angle), 0, 0); },
          [&](float angle) { return glm::vec3(width * std::cos(angle), 0, 0); });
    }
    for (int column = 0; column < kCrowdColumns; ++column) {
      const float x = kSpacing * (static_cast<float>(column) - 0.5f * (kCrowdColumns - 1) +
                                  0.25f * static_cast<float>(row % 2));
      addFigure(builder, figures, (5 * row + 3 * column + row * column % 5) % 8,
                " " + std::to_string(row) + "." + std::to_string(column), {x, 0.0f, 0.0f}, carrier);
    }
  }
}

/// Pegs that run through the gaps between rows, each for itself.
void addRunners(SceneBuilder& builder, const Figures& figures) {
  for (int runner = 0; runner < 12; ++runner) {
    const auto number = static_cast<float>(runner);
    const float phase = 0.9f * number, z = -kSpacing * (2.0f * number + 0.5f);
    const float reach = 5.0f + 0.4f * number;
    const int node = place(builder, "runner " + std::to_string(runner),
                           figures.pegs[static_cast<std::size_t>(runner % 3)], {0, 0, z}, -1, kUpright);
    builder.animateLoop(
        node, kCrowdSeconds, [&](float angle) { return glm::vec3(reach * std::sin(angle + phase), 0, z); },
        [&](float angle) { return glm::vec3(reach * std::cos(angle + phase), 0, 0); });
  }
}

} // namespace

Scene makeCrowdScene() {
  SceneBuilder builder("builtin:crowd");
  const Figures figures = addFigures(builder);
  addCrowdRows(builder, figures);
  addRunners(builder, figures);
  const glm::vec3 eye(0.0f, 2.6f, 4.5f);
  const int camera = builder.addCamera("front", eye, {0.0f, -0.2f, -1.0f}, 0.8f);
  builder.animateLoop(
      camera, kCrowdSeconds,
      [&](float angle) { return eye + glm::vec3(0.3f * std::sin(angle), 0, 0.25f * std::cos(angle)); },
      [](float angle) { return glm::vec3(0.3f * std::cos(angle), 0, -0.25f * std::sin(angle)); });
  builder.scene().shot = {240, 60.0, "gltf:front", {}};
  return builder.finish();
}

} // namespace taa
