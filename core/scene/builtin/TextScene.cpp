// builtin:text: fine print, a zone plate, checkers and a ticker: detail in textures, which every filter of
// the history blurs a little in each moving frame.
#include "core/scene/builtin/BuiltinScenes.h"
#include "core/scene/builtin/Lettering.h"
#include "core/scene/builtin/SceneBuilder.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace taa {

namespace {

constexpr std::array<std::uint8_t, 3> kPaper{236, 232, 220}, kInk{28, 26, 30}, kScreen{10, 16, 20};

constexpr std::string_view kProse =
    "A PICTURE MOVES BY A FRACTION OF A PIXEL IN EACH FRAME, AND EACH TIME THE HISTORY IS READ BETWEEN ITS "
    "PIXELS. A BILINEAR TAP IS A SMALL BLUR. TEN FRAMES ARE TEN BLURS. A CUBIC KEEPS THE EDGES, OVERSHOOTS, "
    "AND NEEDS A CLAMP. READ THIS LINE WHILE THE CAMERA GLIDES, THEN STOP IT.";

/// The prose in lines of at most `letters`, broken between words.
std::vector<std::string_view> proseLines(std::size_t letters) {
  std::vector<std::string_view> lines;
  std::string_view rest = kProse;
  while (rest.size() > letters) {
    const std::size_t end = rest.rfind(' ', letters);
    lines.push_back(rest.substr(0, end));
    rest.remove_prefix(end + 1);
  }
  lines.push_back(rest);
  return lines;
}

/// Print in sizes down to one pixel a dot, from the top down.
SceneImage pageImage() {
  constexpr int kWidth = 976, kBottom = 1016;
  SceneImage page = plainImage("page", 1024, 1024, kPaper);
  paintText(page, 24, 24, 12, "TEMPORAL", kInk);
  paintText(page, 24, 124, 8, "ANTI-ALIASING", kInk);
  int y = 204;
  for (const int scale : {4, 3, 2}) {
    for (const std::string_view line : proseLines(static_cast<std::size_t>(kWidth / (kLetterStep * scale)))) {
      paintText(page, 24, y, scale, line, kInk);
      y += 9 * scale;
    }
    y += 5 * scale;
  }
  const std::vector<std::string_view> fine = proseLines(78); // two columns
  for (std::size_t row = 0; y + 10 < kBottom; ++row, y += 10)
    for (const int column : {0, 1})
      paintText(page, 24 + 500 * column, y, 1,
                fine[(row + static_cast<std::size_t>(2 * column)) % fine.size()], kInk);
  return page;
}

/// A picture in gray: `wave(dx, dy)`, 0 to 1, of the texels from its middle.
template <class Wave>
SceneImage grayImage(std::string name, int width, int height, Wave wave) {
  SceneImage image = plainImage(std::move(name), width, height, kPaper);
  std::size_t at = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x, at += 4) {
      const float dx = static_cast<float>(x) - 0.5f * static_cast<float>(width - 1);
      const float dy = static_cast<float>(y) - 0.5f * static_cast<float>(height - 1);
      const auto gray = static_cast<std::uint8_t>(std::lround(10.0f + 235.0f * wave(dx, dy)));
      for (std::size_t channel = 0; channel < 3; ++channel) image.rgba[at + channel] = gray;
    }
  return image;
}

/// cos(r²): finer and finer rings, a quarter of a cycle a texel at the middle of the border, which is 0.4 a
/// pixel at 540 lines: fine, yet not lost to the mipmaps.
SceneImage zoneImage() {
  constexpr int kSize = 512;
  return grayImage("zone plate", kSize, kSize, [](float dx, float dy) {
    return 0.5f + 0.5f * std::cos(0.5f * 3.1415927f * (dx * dx + dy * dy) / kSize);
  });
}

/// Checkers in four fields, with squares of 16, 8, 4 and 2 texels.
SceneImage checkerImage() {
  constexpr int kField = 128, kFields = 4, kHeight = 64;
  return grayImage("checkers", kField * kFields, kHeight, [](float dx, float dy) {
    const int x = static_cast<int>(dx + 0.5f * kField * kFields), y = static_cast<int>(dy + 0.5f * kHeight);
    const int square = 16 >> (x / kField);
    return (x / square + y / square) % 2 == 0 ? 1.0f : 0.0f;
  });
}

SceneImage screenTickerImage() {
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
  MeshBuilder page, zone, checkers, ticker, jobContext;
  page.quad({-1.65f, -0.9f, 0.0f}, {1.9f, 0, 0}, {0, 1.9f, 0});
  zone.quad({0.42f, -0.2f, 0.0f}, {1.2f, 0, 0}, {0, 1.2f, 0});
  checkers.quad({0.42f, -0.39f, 0.0f}, {1.2f, 0, 0}, {0, 0.15f, 0});
  checkers.quad({0.42f, -0.9f, 0.0f}, {1.2f, 0, 0}, {0, 0.15f, 0});
  ticker.quad({-4.0f, -0.06f, 0.0f}, {8.0f, 0, 0}, {0, 0.26f, 0}, {2.0f, 1.0f});
  jobContext.quad({-4.0f, -2.5f, -0.05f}, {8.0f, 0, 0}, {0, 5.0f, 0});
  builder.addObject("desk", {jobContext.build(builder.addMaterial(paintOf({0.16f, 0.18f, 0.2f}, 0.8f)))});
  builder.addObject("page", {page.build(builder.addMaterial(printed(builder, pageImage())))});
  builder.addObject("zone plate", {zone.build(builder.addMaterial(printed(builder, zoneImage())))});
  builder.addObject("checkers", {checkers.build(builder.addMaterial(printed(builder, checkerImage())))});
  Material amber = printed(builder, screenTickerImage());
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
