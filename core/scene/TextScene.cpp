// builtin:text: fine print, a zone plate and a ticker: detail in textures, which every filter of the history
// blurs a little in each moving frame.
#include "core/scene/BuiltinScenes.h"
#include "core/scene/Lettering.h"
#include "core/scene/SceneBuilder.h"

#include <cmath>

namespace taa {

namespace {

constexpr std::array<std::uint8_t, 3> kPaper{236, 232, 220}, kInk{28, 26, 30}, kScreen{10, 16, 20},
    kAmber{255, 176, 40};

constexpr std::string_view kLines[] = {"A PICTURE MOVES BY A FRACTION OF A PIXEL IN EACH FRAME,",
                                       "AND EACH TIME THE HISTORY IS READ BETWEEN ITS PIXELS.",
                                       "A BILINEAR TAP IS A SMALL BLUR. TEN FRAMES ARE TEN BLURS.",
                                       "A CUBIC KEEPS THE EDGES, OVERSHOOTS, AND NEEDS A CLAMP.",
                                       "READ THIS LINE WHILE THE CAMERA GLIDES, THEN STOP IT."};

/// Print in sizes that halve, from the top down.
SceneImage pageImage() {
  SceneImage page = plainImage("page", 1024, 1024, kPaper);
  paintText(page, 24, 24, 12, "TEMPORAL", kInk);
  paintText(page, 24, 124, 8, "ANTI-ALIASING", kInk);
  int y = 204;
  for (const int scale : {4, 3, 2, 1})
    for (const std::string_view line : kLines) {
      const std::size_t fits = static_cast<std::size_t>(976 / (kLetterStep * scale));
      paintText(page, 24, y, scale, line.substr(0, fits), kInk);
      y += 10 * scale;
    }
  for (int row = 0; y + 10 < 1016; ++row, y += 10)
    for (int column = 0; column < 2; ++column)
      paintText(page, 24 + 500 * column, y, 1,
                kLines[static_cast<std::size_t>(row + column) % std::size(kLines)], kInk);
  return page;
}

/// cos(r²): finer and finer rings, up to one pixel.
SceneImage zoneImage() {
  constexpr int kSize = 512;
  SceneImage image = plainImage("zone plate", kSize, kSize, kPaper);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const float dx = static_cast<float>(x) - 255.5f, dy = static_cast<float>(y) - 255.5f;
      const float wave = 0.5f + 0.5f * std::cos(3.1415927f * (dx * dx + dy * dy) / kSize);
      for (int channel = 0; channel < 3; ++channel)
        image.rgba[4 * (static_cast<std::size_t>(y) * kSize + static_cast<std::size_t>(x)) +
                   static_cast<std::size_t>(channel)] =
            static_cast<std::uint8_t>(std::lround(235.0f * wave) + 10);
    }
  return image;
}

SceneImage tickerImage() {
  SceneImage image = plainImage("ticker", 1024, 64, kScreen);
  paintText(image, 8, 18, 4, "FRAME N IS A FUNCTION - STEP BACK", kAmber);
  return image;
}

Material printed(SceneBuilder& builder, SceneImage image) {
  Material material = paintOf(glm::vec3(1.0f), 0.9f);
  material.baseColorTexture = textureSlot(builder.addImage(std::move(image)));
  return material;
}

} // namespace

Scene makeTextScene() {
  SceneBuilder builder("builtin:text");
  MeshBuilder page, zone, ticker, desk;
  page.quad({-1.65f, -0.9f, 0.0f}, {1.9f, 0, 0}, {0, 1.9f, 0});
  zone.quad({0.42f, -0.2f, 0.0f}, {1.2f, 0, 0}, {0, 1.2f, 0});
  ticker.quad({-4.0f, -0.06f, 0.0f}, {8.0f, 0, 0}, {0, 0.26f, 0}, {2.0f, 1.0f});
  desk.quad({-4.0f, -2.5f, -0.05f}, {8.0f, 0, 0}, {0, 5.0f, 0});
  builder.addObject("desk", {desk.build(builder.addMaterial(paintOf({0.16f, 0.18f, 0.2f}, 0.8f)))});
  builder.addObject("page", {page.build(builder.addMaterial(printed(builder, pageImage())))});
  builder.addObject("zone plate", {zone.build(builder.addMaterial(printed(builder, zoneImage())))});
  Material amber = printed(builder, tickerImage());
  amber.emissive = glm::vec3(1.5f);
  amber.emissiveTexture = amber.baseColorTexture;
  const int band = builder.addObject("ticker", {ticker.build(builder.addMaterial(amber))});
  // Four meters, one width of the picture, to the left in each loop: its end is its start.
  builder.animateSteady(band, 4.0f, {1.0f, -0.62f, 0.02f}, {-3.0f, -0.62f, 0.02f});
  const glm::vec3 eye(0.0f, 0.03f, 2.35f);
  const int camera = builder.addCamera("glide", eye, {0, 0, -1}, 0.80f);
  builder.animateLoop(
      camera, 4.0f,
      [&](float angle) { return eye + glm::vec3(0.12f * std::sin(angle), 0.05f * std::sin(2 * angle), 0); },
      [](float angle) { return glm::vec3(0.12f * std::cos(angle), 0.10f * std::cos(2 * angle), 0); });
  builder.scene().sky.sunDirection = {0.3f, 0.5f, 0.9f};
  builder.scene().shot = {240, 60.0, "gltf:glide", {}};
  return builder.finish();
}

} // namespace taa
