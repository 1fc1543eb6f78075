// builtin:glass: what has no motion that could be followed. Panes of colored glass slide before stripes and
// checkers, a crystal turns, a fountain throws particles, a flip-book and a ticker change on screens that
// stand still.
#include "core/scene/builtin/BuiltinScenes.h"
#include "core/scene/builtin/Lettering.h"
#include "core/scene/builtin/SceneBuilder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

namespace taa {

namespace {

constexpr std::array<std::uint8_t, 3> kDark{24, 26, 30}, kLight{222, 220, 210}, kNight{10, 14, 24};

void fill(SceneImage& image, int left, int top, int width, int height,
          const std::array<std::uint8_t, 3>& color) {
  for (int y = top; y < top + height; ++y)
    for (int x = left; x < left + width; ++x)
      for (std::size_t channel = 0; channel < 3; ++channel)
        image.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                        static_cast<std::size_t>(x)) +
                   channel] = color[channel];
}

/// Stripes on the left, checkers on the right, eight of each.
SceneImage wallImage() {
  constexpr int kCell = 32;
  SceneImage image = plainImage("stripes and checkers", 16 * kCell, 8 * kCell, kLight);
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 16; ++column)
      if ((column + (column < 8 ? 0 : row)) % 2 == 0)
        fill(image, column * kCell, row * kCell, kCell, kCell, kDark);
  return image;
}

constexpr int kPageColumns = 4, kPageRows = 4; ///< of the flip-book

/// Sixteen pictures of a clock: its number, and a bar that fills.
SceneImage flipBookImage() {
  constexpr int kCell = 128;
  SceneImage image = plainImage("flip-book", kPageColumns * kCell, kPageRows * kCell, kNight);
  for (int i = 0; i < kPageColumns * kPageRows; ++i) {
    const int left = i % kPageColumns * kCell, top = i / kPageColumns * kCell;
    const std::string number = std::to_string(i + 1);
    paintText(image, left + (number.size() > 1 ? 12 : 40), top + 16, 9, number, kAmber);
    fill(image, left + 8, top + 100, 7 * (i + 1), 16, kLight);
  }
  return image;
}

SceneImage glassTickerImage() {
  SceneImage image = plainImage("ticker", 512, 32, kNight);
  paintText(image, 8, 4, 3, "NO MOTION VECTOR FOLLOWS THIS", kAmber);
  return image;
}

/// A round spot that fades out, in alpha.
SceneImage spotImage() {
  constexpr int kSize = 32;
  SceneImage image = plainImage("spot", kSize, kSize, {255, 255, 255});
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const glm::vec2 way = (glm::vec2(x, y) + 0.5f - 0.5f * kSize) / (0.5f * kSize);
      const float rest = std::max(0.0f, 1.0f - glm::dot(way, way));
      image.rgba[4 * static_cast<std::size_t>(y * kSize + x) + 3] =
          static_cast<std::uint8_t>(std::lround(255.0f * rest));
    }
  return image;
}

Material glassOf(const glm::vec4& color) {
  Material material = paintOf(glm::vec3(color), 0.08f);
  material.baseColor.w = color.w;
  material.alphaMode = AlphaMode::Blend;
  material.doubleSided = true;
  return material;
}

/// What shines by itself and says that no motion tells how it changes.
Material screenOf(SceneBuilder& builder, SceneImage image, const UvAnimation& animation) {
  Material material = paintOf(glm::vec3(1.0f), 1.0f);
  material.unlit = material.responsive = true;
  material.uvAnimation = animation;
  material.baseColorTexture = textureSlot(builder.addImage(std::move(image)));
  return material;
}

/// A pane in its plane, `way` meters to both sides and back in `seconds`.
void addPane(SceneBuilder& builder, const std::string& name, const glm::vec3& place, float way, float seconds,
             const glm::vec4& color) {
  MeshBuilder mesh;
  mesh.quad({-0.55f, -0.8f, 0.0f}, {1.1f, 0, 0}, {0, 1.6f, 0});
  const int pane = builder.addObject(name, {mesh.build(builder.addMaterial(glassOf(color)))});
  builder.animateLoop(
      pane, seconds, [=](float angle) { return place + glm::vec3(way * std::sin(angle), 0, 0); },
      [=](float angle) { return glm::vec3(way * std::cos(angle), 0, 0); });
}

/// Where particle `index` of a fountain is `seconds` after its birth.
glm::vec3 thrown(int index, float seconds) {
  const float angle = 2.3999632f * static_cast<float>(index); // the golden angle
  const float speed = 0.25f + 0.2f * static_cast<float>(index % 5) / 4.0f;
  return {speed * std::cos(angle) * seconds, 3.6f * seconds - 2.0f * seconds * seconds,
          speed * std::sin(angle) * seconds};
}

/// Spots that face along +z, baked frame by frame with their velocities. One color: blended over each other
/// they look the same in any order.
Primitive particles(int count, int material) {
  constexpr int kFrames = 120;
  constexpr float kRate = 60.0f, kLife = kFrames / kRate, kHalf = 0.07f;
  MeshBuilder mesh;
  for (int i = 0; i < count; ++i)
    mesh.quad({-kHalf, -kHalf, 0.0f}, {2.0f * kHalf, 0, 0}, {0, 2.0f * kHalf, 0});
  Primitive primitive = mesh.build(material);
  primitive.cache.frames = kFrames;
  primitive.cache.framesPerSecond = static_cast<double>(kRate);
  for (int frame = 0; frame < kFrames; ++frame)
    for (std::size_t vertex = 0; vertex < primitive.vertices.size(); ++vertex) {
      const int particle = static_cast<int>(vertex / 4);
      const float age = std::fmod(static_cast<float>(frame) / kRate +
                                      kLife * static_cast<float>(particle) / static_cast<float>(count),
                                  kLife);
      const glm::vec3 now = thrown(particle, age), before = thrown(particle, age - 1.0f / kRate);
      primitive.cache.entries.push_back({primitive.vertices[vertex].position + now,
                                         primitive.vertices[vertex].normal, kRate * (now - before)});
    }
  return primitive;
}

void addFountain(SceneBuilder& builder, const glm::vec3& place) {
  Material spark = screenOf(builder, spotImage(), {});
  spark.alphaMode = AlphaMode::Blend;
  spark.baseColor = {1.0f, 0.75f, 0.25f, 0.8f};
  builder.addObject("fountain", {particles(60, builder.addMaterial(spark))});
  builder.scene().nodes.back().translation = place;
  MeshBuilder basin;
  const glm::vec2 profile[] = {{0.0f, 0.1f}, {0.3f, 0.1f}, {0.35f, -0.1f}, {0.0f, -0.1f}};
  basin.lathe(glm::vec3(0.0f), profile, 32);
  const int node =
      builder.addObject("basin", {basin.build(builder.addMaterial(paintOf({0.4f, 0.4f, 0.42f}, 0.5f)))});
  Node& stand = builder.scene().nodes[static_cast<std::size_t>(node)];
  stand.translation = place - glm::vec3(0, 0.05f, 0);
  stand.rotation = glm::angleAxis(-0.25f * kTurn, glm::vec3(1, 0, 0)); // its axis upright
}

void addScreens(SceneBuilder& builder) {
  MeshBuilder book, ticker;
  book.quad({-2.6f, 1.15f, -2.2f}, {1.1f, 0, 0}, {0, 1.1f, 0});
  ticker.quad({-2.6f, 0.75f, -2.2f}, {2.4f, 0, 0}, {0, 0.25f, 0}, {0.8f, 1.0f});
  Material pages = screenOf(builder, flipBookImage(), {kPageColumns, kPageRows, 12.0f});
  pages.baseColorTexture.sampler.mipmaps = Mipmaps::None; // a coarse level would mix neighboring pictures
  builder.addObject("flip-book", {book.build(builder.addMaterial(pages))});
  builder.addObject(
      "ticker",
      {ticker.build(builder.addMaterial(screenOf(builder, glassTickerImage(), {1, 1, 0, {0.5f, 0}})))});
}

void addCrystal(SceneBuilder& builder, const glm::vec3& place) {
  MeshBuilder mesh;
  mesh.box({-0.45f, -0.12f, -0.12f}, {0.45f, 0.12f, 0.12f});
  mesh.box({-0.12f, -0.45f, -0.121f}, {0.12f, 0.45f, 0.121f});
  Material crystal = glassOf({0.6f, 0.85f, 0.9f, 0.35f});
  crystal.doubleSided = false; // the far sides would come over the near ones
  const int tilted = builder.addNode("crystal's tilt", place, glm::angleAxis(0.5f, glm::vec3(0, 1, 0)));
  builder.animateSpin(builder.addObject("crystal", {mesh.build(builder.addMaterial(crystal))}, tilted), 4.0f,
                      1);
}

} // namespace

Scene makeGlassScene() {
  SceneBuilder builder("builtin:glass");
  Material wall = paintOf(glm::vec3(1.0f), 0.9f);
  wall.baseColorTexture = textureSlot(builder.addImage(wallImage()));
  MeshBuilder wallMesh, floorMesh;
  wallMesh.quad({-5.0f, 0.0f, -2.5f}, {10.0f, 0, 0}, {0, 4.0f, 0}, {2.0f, 1.6f});
  floorMesh.quad({-5.0f, 0.0f, 3.0f}, {10.0f, 0, 0}, {0, 0, -5.5f});
  builder.addObject("wall", {wallMesh.build(builder.addMaterial(wall))});
  builder.addObject("floor", {floorMesh.build(builder.addMaterial(paintOf({0.35f, 0.33f, 0.3f}, 0.6f)))});
  addScreens(builder);
  addPane(builder, "red pane", {-0.5f, 1.5f, -1.2f}, 0.8f, 4.0f, {0.9f, 0.12f, 0.1f, 0.55f});
  addPane(builder, "green pane", {0.1f, 1.3f, -0.6f}, -1.0f, 2.0f, {0.1f, 0.7f, 0.2f, 0.45f});
  addPane(builder, "blue pane", {-0.6f, 1.1f, 0.0f}, 0.5f, 4.0f, {0.1f, 0.25f, 0.9f, 0.6f});
  addCrystal(builder, {1.15f, 1.75f, -0.4f});
  addFountain(builder, {1.9f, 0.2f, -0.8f});
  builder.addCamera("front", {0.0f, 1.4f, 4.2f}, {0.0f, -0.02f, -1.0f}, 0.72f);
  Scene& scene = builder.scene();
  scene.sky.sunDirection = {-0.4f, 0.7f, 0.9f};
  scene.shot = {240, 60.0, "gltf:front", {}};
  return builder.finish();
}

} // namespace taa
