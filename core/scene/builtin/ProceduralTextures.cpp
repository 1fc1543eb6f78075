#include "core/scene/builtin/ProceduralTextures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace taa {

namespace {

constexpr int kTextureSize = 512; ///< pixels on a side

/// Rounds as lround does, which is a slow call; a double holds the sum exactly.
std::uint8_t toByte(float value) {
  const double above = static_cast<double>(255.0f * std::clamp(value, 0.0f, 1.0f)) + 0.5;
  return static_cast<std::uint8_t>(above);
}

/// Asks `color(u, v)` (RGBA, 0 to 1, as the file would hold it) at each pixel's center.
template <class Color>
SceneImage paint(std::string name, Color color) {
  SceneImage image{std::move(name), kTextureSize, kTextureSize, {}};
  image.rgba.resize(static_cast<std::size_t>(kTextureSize) * kTextureSize * 4);
  auto byte = image.rgba.begin();
  for (int y = 0; y < kTextureSize; ++y)
    for (int x = 0; x < kTextureSize; ++x) {
      const glm::vec4 value =
          color((static_cast<float>(x) + 0.5f) / kTextureSize, (static_cast<float>(y) + 0.5f) / kTextureSize);
      for (int channel = 0; channel < 4; ++channel) *byte++ = toByte(value[channel]);
    }
  return image;
}

int wrappedIndex(int i, int period) {
  if (i >= 0 && i < period) return i; // nearly always, and the division is slow
  return ((i % period) + period) % period;
}

/// Slopes of `height(u, v)` (in texture widths) as a normal map.
template <class Height>
SceneImage paintNormals(std::string name, Height height) {
  std::vector<float> heights;
  heights.reserve(static_cast<std::size_t>(kTextureSize) * kTextureSize);
  for (int y = 0; y < kTextureSize; ++y)
    for (int x = 0; x < kTextureSize; ++x)
      heights.push_back(height((static_cast<float>(x) + 0.5f) / kTextureSize,
                               (static_cast<float>(y) + 0.5f) / kTextureSize));
  const auto at = [&](int x, int y) {
    return heights[static_cast<std::size_t>(wrappedIndex(y, kTextureSize)) * kTextureSize +
                   static_cast<std::size_t>(wrappedIndex(x, kTextureSize))];
  };
  return paint(std::move(name), [&](float u, float v) {
    const int x = static_cast<int>(u * kTextureSize), y = static_cast<int>(v * kTextureSize);
    const float slopeU = 0.5f * kTextureSize * (at(x + 1, y) - at(x - 1, y));
    const float slopeUp = 0.5f * kTextureSize * (at(x, y - 1) - at(x, y + 1));
    const glm::vec3 normal = glm::normalize(glm::vec3(-slopeU, -slopeUp, 1.0f));
    return glm::vec4(0.5f * normal + 0.5f, 1.0f);
  });
}

float random(int x, int y, int seed) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 0x9E3779B1u ^
                    static_cast<std::uint32_t>(y) * 0x85EBCA77u ^
                    static_cast<std::uint32_t>(seed) * 0xC2B2AE3Du;
  h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
  h = (h ^ (h >> 12)) * 0x297A2D39u;
  return static_cast<float>((h ^ (h >> 15)) >> 8) / 16777216.0f;
}

/// Value noise with `cells` cells across, 0 to 1; tiles. Expects u and v of at least 0.
float noise(float u, float v, int cells, int seed) {
  const float x = u * static_cast<float>(cells), y = v * static_cast<float>(cells);
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
  const float fx = x - static_cast<float>(x0), fy = y - static_cast<float>(y0);
  const float sx = fx * fx * (3 - 2 * fx), sy = fy * fy * (3 - 2 * fy);
  const auto at = [&](int i, int j) {
    return random(wrappedIndex(x0 + i, cells), wrappedIndex(y0 + j, cells), seed);
  };
  const float top = at(0, 0) + sx * (at(1, 0) - at(0, 0)), bottom = at(0, 1) + sx * (at(1, 1) - at(0, 1));
  return top + sy * (bottom - top);
}

float grain(float u, float v, int seed) {
  return 0.5f * noise(u, v, 16, seed) + 0.3f * noise(u, v, 64, seed + 1) + 0.2f * noise(u, v, 256, seed + 2);
}

float smoothEdge(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

glm::vec4 opaque(const glm::vec3& color) {
  return {color, 1.0f};
}

// Below, coordinates are at least 0, so that a conversion to int is the floor; calls of floor are slow.

/// Where a point lies in a wall of equal blocks: which block, and how deep inside it.
struct Block {
  int column, row;
  float inside; ///< 0 at the block's border, growing inwards, in texture widths
};

Block blockAt(float u, float v, int columns, int rows, float shiftPerRow) {
  const float y = v * static_cast<float>(rows);
  const int row = static_cast<int>(y);
  const float x = u * static_cast<float>(columns) + shiftPerRow * static_cast<float>(wrappedIndex(row, 2));
  const int column = static_cast<int>(x);
  const float fx = x - static_cast<float>(column), fy = y - static_cast<float>(row);
  return {wrappedIndex(column, columns), wrappedIndex(row, rows),
          std::min(std::min(fx, 1 - fx) / static_cast<float>(columns),
                   std::min(fy, 1 - fy) / static_cast<float>(rows))};
}

constexpr int kBrickColumns = 4, kBrickRows = 12;

float brickHeight(float u, float v) {
  const Block brick = blockAt(u, v, kBrickColumns, kBrickRows, 0.5f);
  return 0.006f * smoothEdge(0.003f, 0.012f, brick.inside) + 0.0035f * grain(u, v, 7);
}

constexpr int kPlanks = 8;

/// A board that runs along v without end.
Block plankAt(float u) {
  const float x = u * kPlanks;
  const int column = static_cast<int>(x);
  const float fx = x - static_cast<float>(column);
  return {wrappedIndex(column, kPlanks), 0, std::min(fx, 1 - fx) / kPlanks};
}

float plankHeight(float u, float v) {
  const Block plank = plankAt(u);
  return 0.008f * smoothEdge(0.001f, 0.008f, plank.inside) + 0.002f * noise(u, 0.06f * v, 256, plank.column);
}

} // namespace

SurfaceImages brickImages() {
  SceneImage color = paint("bricks", [](float u, float v) {
    const Block brick = blockAt(u, v, kBrickColumns, kBrickRows, 0.5f);
    const float tone = random(brick.column, brick.row, 3), rough = grain(u, v, 7);
    const glm::vec3 clay = glm::vec3(0.50f, 0.27f, 0.21f) + (tone - 0.5f) * glm::vec3(0.22f, 0.15f, 0.12f);
    const glm::vec3 mortar(0.60f, 0.57f, 0.53f);
    const float filled = smoothEdge(0.003f, 0.007f, brick.inside);
    return opaque((mortar + filled * (clay - mortar)) * (0.72f + 0.5f * rough));
  });
  return {std::move(color), paintNormals("brick normals", brickHeight)};
}

SurfaceImages plankImages() {
  SceneImage color = paint("planks", [](float u, float v) {
    const Block plank = plankAt(u);
    const float tone = random(plank.column, 0, 5), fiber = noise(u, 0.06f * v, 256, plank.column);
    const float gap = smoothEdge(0.001f, 0.004f, plank.inside);
    return opaque(glm::vec3(0.92f) * (0.80f + 0.12f * tone + 0.14f * (fiber - 0.5f)) * (0.35f + 0.65f * gap));
  });
  return {std::move(color), paintNormals("plank normals", plankHeight)};
}

SceneImage tileImage() {
  return paint("tiles", [](float u, float v) {
    const Block tile = blockAt(u, v, 4, 4, 0.0f);
    const bool dark = (tile.column + tile.row) % 2 == 0;
    const glm::vec3 stone = dark ? glm::vec3(0.16f, 0.20f, 0.24f) : glm::vec3(0.78f, 0.76f, 0.71f);
    const float joint = smoothEdge(0.001f, 0.003f, tile.inside);
    const glm::vec3 groove(0.36f, 0.35f, 0.33f);
    return opaque((groove + joint * (stone - groove)) *
                  (0.86f + 0.28f * grain(u, v, tile.column + 4 * tile.row)));
  });
}

SceneImage slabImage() {
  return paint("slabs", [](float u, float v) {
    const Block slab = blockAt(u, v, 2, 2, 0.0f);
    const float joint = smoothEdge(0.001f, 0.003f, slab.inside);
    const float patch = noise(u, v, 6, 41 + slab.column + 2 * slab.row);
    return opaque(glm::vec3(0.66f, 0.65f, 0.63f) * (0.72f + 0.28f * joint) *
                  (0.88f + 0.08f * patch + 0.12f * grain(u, v, 45)));
  });
}

SceneImage grassImage() {
  return paint("grass", [](float u, float v) {
    const float patch = noise(u, v, 6, 21), blade = grain(u, v, 23);
    const glm::vec3 lush(0.30f, 0.43f, 0.17f), dry(0.55f, 0.52f, 0.28f);
    return opaque((lush + smoothEdge(0.45f, 0.9f, patch) * (dry - lush)) * (0.55f + 0.9f * blade));
  });
}

SceneImage gravelImage() {
  return paint("gravel", [](float u, float v) {
    const float stone = 0.6f * noise(u, v, 128, 31) + 0.4f * noise(u, v, 256, 32), patch = noise(u, v, 8, 33);
    return opaque(glm::vec3(0.60f, 0.54f, 0.46f) * (0.55f + 0.6f * stone + 0.2f * patch));
  });
}

SceneImage posterImage() {
  return paint("test chart", [](float u, float v) {
    const glm::vec3 paper(0.93f, 0.91f, 0.86f), ink(0.08f, 0.10f, 0.14f), accent(0.85f, 0.33f, 0.16f);
    const auto mix = [&](const glm::vec3& a, const glm::vec3& b, float t) { return opaque(a + t * (b - a)); };
    if (std::min(std::min(u, 1 - u), std::min(v, 1 - v)) < 0.03f) return opaque(ink);
    constexpr float kPi = std::numbers::pi_v<float>;
    if (v < 0.5f) { // zone plate: rings that get finer outwards
      const float dv = kPosterAspect * (v - 0.27f), r2 = (u - 0.5f) * (u - 0.5f) + dv * dv;
      return mix(paper, ink, r2 < 0.085f ? 0.5f - 0.5f * std::cos(2 * kPi * 260.0f * r2) : 0.0f);
    }
    if (v < 0.72f) { // lines that get finer to the right
      const float x = (u - 0.08f) / 0.84f;
      const bool lined = x > 0.0f && x < 1.0f && v > 0.54f;
      return mix(paper, ink, lined ? 0.5f + 0.5f * std::sin(2 * kPi * (6.0f * x + 34.0f * x * x)) : 0.0f);
    }
    const float dv = kPosterAspect * (v - 0.85f), angle = std::atan2(dv, u - 0.5f),
                r = std::hypot(u - 0.5f, dv);
    if (r < 0.145f) return mix(paper, ink, std::sin(36.0f * angle) > 0.0f ? 1.0f : 0.0f); // spokes
    return mix(paper, accent,
               u < 0.32f || u > 0.68f ? smoothEdge(0.0f, 0.02f, 0.07f - std::abs(v - 0.86f)) : 0.0f);
  });
}

SceneImage netImage() {
  return paint("net", [](float u, float v) {
    constexpr float kMeshes = 8.0f, kWire = 0.09f; // wires a side; half a wire's width, of a mesh
    const auto toWire = [](float x) { return std::abs(x - std::round(x)); };
    const float distance = std::min(toWire(kMeshes * (u + v)), toWire(kMeshes * (u - v)));
    const float shade = 0.62f + 0.25f * (1.0f - distance / kWire);
    return glm::vec4(glm::vec3(std::clamp(shade, 0.3f, 0.9f)),
                     smoothEdge(kWire + 0.04f, kWire - 0.04f, distance));
  });
}

} // namespace taa
