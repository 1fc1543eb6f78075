// builtin:disocclusion: wide boards slide at different speeds before a detailed wall, which they uncover
// behind them frame after frame.
#include "core/scene/builtin/BuiltinScenes.h"
#include "core/scene/builtin/ProceduralTextures.h"
#include "core/scene/builtin/SceneBuilder.h"

#include <cmath>
#include <utility>

namespace taa {

namespace {

/// A board on the floor that slides `reach` meters to both sides, `turns` times in the loop.
void addMovingBoard(SceneBuilder& builder, int material, float width, float z, float reach, int turns,
                    float phase) {
  MeshBuilder mesh;
  mesh.box({-0.5f * width, 0.0f, -0.05f}, {0.5f * width, 2.7f, 0.05f}, 0.7f);
  const int node = builder.addObject("board", {mesh.build(material)});
  const float speed = static_cast<float>(turns);
  builder.animateLoop(
      node, 4.0f, [=](float angle) { return glm::vec3(reach * std::sin(speed * angle + phase), 0.0f, z); },
      [=](float angle) { return glm::vec3(reach * speed * std::cos(speed * angle + phase), 0, 0); });
}

} // namespace

Scene makeDisocclusionScene() {
  SceneBuilder builder("builtin:disocclusion");
  SurfaceImages bricks = brickImages(), planks = plankImages();
  Material brick = paintOf(glm::vec3(1.0f), 0.85f), chart = brick, tile = paintOf(glm::vec3(1.0f), 0.4f);
  brick.baseColorTexture = textureSlot(builder.addImage(std::move(bricks.color)));
  brick.normalTexture = textureSlot(builder.addImage(std::move(bricks.normal)));
  chart.baseColorTexture = textureSlot(builder.addImage(posterImage()));
  tile.baseColorTexture = textureSlot(builder.addImage(tileImage()));
  Material wood = paintOf({0.95f, 0.85f, 0.7f}, 0.6f);
  wood.baseColorTexture = textureSlot(builder.addImage(std::move(planks.color)));
  wood.normalTexture = textureSlot(builder.addImage(std::move(planks.normal)));
  MeshBuilder wall, floor, charts;
  wall.quad({-7.0f, 0.0f, -3.0f}, {14.0f, 0, 0}, {0, 5.0f, 0}, {11.0f, 4.0f});
  floor.quad({-7.0f, 0.0f, 4.0f}, {14.0f, 0, 0}, {0, 0, -7.0f}, {11.0f, 5.5f});
  for (int i = 0; i < 4; ++i)
    charts.quad({-4.4f + 2.4f * static_cast<float>(i), 0.7f, -2.98f}, {1.5f, 0, 0},
                {0, 1.5f * kPosterAspect, 0});
  builder.addObject("wall", {wall.build(builder.addMaterial(brick))});
  builder.addObject("floor", {floor.build(builder.addMaterial(tile))});
  builder.addObject("charts", {charts.build(builder.addMaterial(chart))});
  const int board = builder.addMaterial(wood), red = builder.addMaterial(paintOf({0.7f, 0.08f, 0.05f}, 0.5f)),
            steel = builder.addMaterial(paintOf({0.7f, 0.72f, 0.75f}, 0.25f, 1.0f));
  addMovingBoard(builder, board, 1.1f, 0.6f, 2.6f, 1, 0.0f);
  addMovingBoard(builder, red, 0.5f, -0.6f, 3.2f, 2, 1.2f);
  addMovingBoard(builder, steel, 0.22f, 1.4f, 1.5f, 1, 2.8f);
  addMovingBoard(builder, red, 0.3f, -1.8f, 3.8f, 1, 4.4f);
  const glm::vec3 eye(0.0f, 1.7f, 5.6f);
  const int camera = builder.addCamera("strafe", eye, {0.0f, -0.06f, -1.0f}, 0.75f);
  builder.animateLoop(
      camera, 4.0f, [&](float angle) { return eye + glm::vec3(0.5f * std::sin(angle), 0, 0); },
      [](float angle) { return glm::vec3(0.5f * std::cos(angle), 0, 0); });
  builder.scene().sky.sunDirection = {-0.5f, 0.8f, 0.7f};
  builder.scene().shot = {240, 60.0, "gltf:strafe", {}};
  return builder.finish();
}

} // namespace taa
