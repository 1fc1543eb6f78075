// builtin:thin: lines one pixel and half a pixel wide at every slope, at 540 lines a picture. Their coverage
// is known: the camera is orthographic and faces them, so that a line of l by w pixels covers l·w pixels in
// sum wherever it lies, each pixel by the part of its square inside the line. Those of the lower rows drift
// by less than a third of a pixel a frame.
#include "core/scene/builtin/BuiltinScenes.h"
#include "core/scene/builtin/SceneBuilder.h"

#include <cmath>
#include <numbers>

namespace taa {

namespace {

constexpr float kPixel = 0.01f;  ///< meters
constexpr float kLength = 85.0f; ///< pixels of a line of the rows
constexpr float kLong = 800.0f;  ///< pixels of a line that is nearly level
constexpr int kSlopes = 18;
constexpr float kDrift = 0.1f; ///< meters to all sides; no line leaves the picture at 16:9

/// A line around the origin at `angle`, `length` by `width` pixels.
Primitive line(float angle, float length, float width, int material) {
  const glm::vec3 along(std::cos(angle), std::sin(angle), 0.0f), across(-along.y, along.x, 0.0f);
  MeshBuilder mesh;
  mesh.quad(-0.5f * kPixel * (length * along + width * across), kPixel * length * along,
            kPixel * width * across);
  return mesh.build(material);
}

/// Lines that rise by one pixel in so many: the slower they rise, the longer the steps that crawl along them.
void addShallowLines(SceneBuilder& builder, int material) {
  float y = -0.55f; // of a line's left end
  for (const float run : {128.0f, 64.0f, 32.0f, 16.0f, 10.0f}) {
    const float angle = std::atan(1.0f / run);
    builder.addObject("shallow", {line(angle, kLong, 1.0f, material)});
    builder.scene().nodes.back().translation = {0.0f, y + 0.5f * kPixel * kLong * std::sin(angle), 0.0f};
    y += 0.1f;
  }
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
    const float x = -4.25f + static_cast<float>(i % 9) * 1.0625f, row = i < 9 ? 0.0f : 1.0f;
    builder.addObject("one pixel", {line(angle, kLength, 1.0f, lines)});
    builder.scene().nodes.back().translation = {x, 2.1f - row, 0.0f};
    builder.addObject("half a pixel", {line(angle, kLength, 0.5f, lines)}, drifting);
    builder.scene().nodes.back().translation = {x, -1.1f - row, 0.0f};
  }
  addShallowLines(builder, lines);
  builder.animateLoop(
      drifting, 4.0f, [](float angle) { return kDrift * glm::vec3(std::sin(angle), std::cos(angle), 0.0f); },
      [](float angle) { return kDrift * glm::vec3(std::cos(angle), -std::sin(angle), 0.0f); });
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
