// builtin:thin: lines one pixel wide at every slope, at 540 lines a picture: their coverage is known, for the
// camera is orthographic and a line of length l covers l pixels. Those of the lower row drift.
#include "core/scene/BuiltinScenes.h"
#include "core/scene/SceneBuilder.h"

#include <cmath>
#include <numbers>

namespace taa {

namespace {

constexpr float kPixel = 0.01f;  ///< meters
constexpr float kLength = 0.85f; ///< meters of a line
constexpr int kSlopes = 18;

/// A line around the origin at `angle`, `width` pixels wide.
Primitive line(float angle, float width, int material) {
  const glm::vec3 along(std::cos(angle), std::sin(angle), 0.0f), across(-along.y, along.x, 0.0f);
  MeshBuilder mesh;
  mesh.quad(-0.5f * kLength * along - 0.5f * width * kPixel * across, kLength * along,
            width * kPixel * across);
  return mesh.build(material);
}

} // namespace

Scene makeThinScene() {
  SceneBuilder builder("builtin:thin");
  Material white = paintOf(glm::vec3(1.0f), 1.0f), dark = paintOf(glm::vec3(0.02f), 1.0f);
  white.unlit = dark.unlit = true;
  const int lines = builder.addMaterial(white), board = builder.addMaterial(dark);
  MeshBuilder back;
  back.quad({-8.0f, -4.0f, -1.0f}, {16.0f, 0, 0}, {0, 8.0f, 0});
  builder.addObject("board", {back.build(board)});
  const int drifting = builder.addNode("drifting", glm::vec3(0.0f));
  for (int i = 0; i < kSlopes; ++i) {
    const float angle = std::numbers::pi_v<float> * static_cast<float>(i) / kSlopes;
    const float x = -4.25f + static_cast<float>(i % 9) * 1.0625f, row = static_cast<float>(i / 9);
    builder.addObject("one pixel", {line(angle, 1.0f, lines)});
    builder.scene().nodes.back().translation = {x, 2.1f - row, 0.0f};
    builder.addObject("half a pixel", {line(angle, 0.5f, lines)}, drifting);
    builder.scene().nodes.back().translation = {x, -1.1f - row, 0.0f};
  }
  builder.animateLoop(
      drifting, 4.0f,
      [](float angle) { return glm::vec3(0.3f * std::sin(angle), 0.1f * std::cos(angle), 0.0f); },
      [](float angle) { return glm::vec3(0.3f * std::cos(angle), -0.1f * std::sin(angle), 0.0f); });
  builder.addCamera("flat", {0.0f, 0.0f, 5.0f}, {0, 0, -1}, 0.8f);
  SceneCamera& camera = builder.scene().cameras.back();
  camera.orthographic = true;
  camera.height = 540.0f * kPixel;
  camera.farPlane = 20.0f;
  builder.scene().sky.sunEnabled = false;
  builder.scene().shot = {240, 60.0, "gltf:flat", {}};
  return builder.finish();
}

} // namespace taa
