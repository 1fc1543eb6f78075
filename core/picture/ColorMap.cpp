#include "core/picture/ColorMap.h"

#include "core/base/Light.h"
#include "core/picture/OkLab.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>

namespace taa {

namespace {

// Stops of viridis and inferno (S. van der Walt and N. Smith, 2015, CC0), sRGB, evenly spaced.
constexpr std::array<std::uint32_t, 10> kViridis = {0x440154, 0x482878, 0x3e4a89, 0x31688e, 0x26828e,
                                                    0x1f9e89, 0x35b779, 0x6dcd59, 0xb4de2c, 0xfde725};
constexpr std::array<std::uint32_t, 10> kInferno = {0x000004, 0x1b0c42, 0x4b0c6b, 0x781c6d, 0xa52c60,
                                                    0xcf4446, 0xed6925, 0xfb9a06, 0xf7d03c, 0xfcffa4};

// Ten colors whose lightness differs too: OKLab lightness, chroma, hue in degrees. Number 0 is a gray of its
// own; neighbors in the list are far apart in lightness and in the blue-yellow direction, which all eyes tell
// apart. The last two are those farthest from all others for eyes that lack one kind of cones.
struct Lch {
  float lightness, chroma, hue;
};
constexpr std::array<Lch, kCategoryCount> kCategories{{{0.34f, 0.0f, 0.0f},
                                                       {0.70f, 0.16f, 55.0f},
                                                       {0.48f, 0.17f, 265.0f},
                                                       {0.88f, 0.16f, 105.0f},
                                                       {0.56f, 0.20f, 15.0f},
                                                       {0.81f, 0.09f, 225.0f},
                                                       {0.63f, 0.13f, 155.0f},
                                                       {0.41f, 0.17f, 320.0f},
                                                       {0.748f, 0.071f, 132.0f},
                                                       {0.94f, 0.12f, 149.0f}}};

glm::vec3 stop(std::uint32_t hex) {
  return glm::vec3(hex >> 16, (hex >> 8) & 255u, hex & 255u) / 255.0f;
}

// Linear Rec. 709.
glm::vec3 fromLch(const Lch& color) {
  const float hue = color.hue * std::numbers::pi_v<float> / 180.0f;
  return linearOfOkLab({color.lightness, color.chroma * std::cos(hue), color.chroma * std::sin(hue)});
}

glm::vec3 decoded(const glm::vec3& encoded) {
  return {srgbDecoded(encoded.x), srgbDecoded(encoded.y), srgbDecoded(encoded.z)};
}

// A cubic through the stops, in encoded values.
glm::vec3 throughStops(const std::array<std::uint32_t, 10>& stops, float value) {
  const float position = value * static_cast<float>(stops.size() - 1);
  const int index = std::min(static_cast<int>(position), static_cast<int>(stops.size()) - 2);
  const float f = position - static_cast<float>(index);
  const auto at = [&](int k) {
    return stop(stops[static_cast<std::size_t>(std::clamp(k, 0, static_cast<int>(stops.size()) - 1))]);
  };
  const glm::vec3 before = at(index - 1), a = at(index), b = at(index + 1), after = at(index + 2);
  const glm::vec3 slopeA = 0.5f * (b - before), slopeB = 0.5f * (after - a);
  const glm::vec3 cubic =
      a +
      f * (slopeA + f * (3.0f * (b - a) - 2.0f * slopeA - slopeB + f * (2.0f * (a - b) + slopeA + slopeB)));
  return decoded(
      {std::clamp(cubic.x, 0.0f, 1.0f), std::clamp(cubic.y, 0.0f, 1.0f), std::clamp(cubic.z, 0.0f, 1.0f)});
}

// Dark neutral gray in the middle; blue below, orange above, equally light at equal distance.
glm::vec3 diverging(float value) {
  const float distance = std::abs(2.0f * value - 1.0f);
  const float lightness = 0.34f + 0.42f * distance;
  if (value == 0.5f) return glm::vec3(lightness * lightness * lightness); // exactly neutral
  return fromLch({lightness, 0.13f * distance, value < 0.5f ? 245.0f : 60.0f});
}

glm::vec3 entryOf(ColorMap map, int index) {
  const float value = static_cast<float>(index) / static_cast<float>(kColorMapEntries - 1);
  switch (map) {
  case ColorMap::Gray:
    return glm::vec3(srgbDecoded(value));
  case ColorMap::Viridis:
    return throughStops(kViridis, value);
  case ColorMap::Inferno:
    return throughStops(kInferno, value);
  case ColorMap::Diverging:
    return diverging(value);
  case ColorMap::Cyclic: // the last entry is the first again
    return fromLch(
        {kCyclicLightness, 0.115f, 360.0f * (index == kColorMapEntries - 1 ? 0.0f : value) + 25.0f});
  case ColorMap::Categorical:
    return index < kCategoryCount ? fromLch(kCategories[static_cast<std::size_t>(index)]) : glm::vec3(0.0f);
  }
  return glm::vec3(0.0f);
}

Image makeTable() {
  Image table(kColorMapEntries, kColorMapCount, 4);
  for (int map = 0; map < kColorMapCount; ++map)
    for (int index = 0; index < kColorMapEntries; ++index) {
      const glm::vec3 color = entryOf(static_cast<ColorMap>(map), index);
      float* entry = table.at(index, map);
      entry[0] = color.x;
      entry[1] = color.y;
      entry[2] = color.z;
      entry[3] = 1.0f;
    }
  return table;
}

std::array<float, 3> entry(ColorMap map, int index) {
  const float* texel = colorMapTable().at(index, static_cast<int>(map));
  return {texel[0], texel[1], texel[2]};
}

} // namespace

const Image& colorMapTable() {
  static const Image table = makeTable();
  return table;
}

std::array<float, 3> categoryColor(int number) {
  const int others = kCategoryCount - 1;
  return entry(ColorMap::Categorical, number == 0 ? 0 : 1 + ((number - 1) % others + others) % others);
}

std::array<float, 3> mapColor(ColorMap map, float value) {
  if (map == ColorMap::Cyclic) value -= std::floor(value);
  const float t = value > 0.0f ? (value < 1.0f ? value : 1.0f) : 0.0f;
  if (map == ColorMap::Categorical)
    return entry(map, std::min(static_cast<int>(t * kCategoryCount), kCategoryCount - 1));
  const float position = t * static_cast<float>(kColorMapEntries - 1);
  const int index = std::min(static_cast<int>(position), kColorMapEntries - 2);
  const float f = position - static_cast<float>(index);
  const std::array<float, 3> a = entry(map, index), b = entry(map, index + 1);
  return {a[0] + f * (b[0] - a[0]), a[1] + f * (b[1] - a[1]), a[2] + f * (b[2] - a[2])};
}

std::string_view colorMapName(ColorMap map) {
  static constexpr std::array<std::string_view, kColorMapCount> kNames = {
      "Gray", "Viridis", "Inferno", "Diverging", "Cyclic", "Categorical"};
  return kNames[static_cast<std::size_t>(map)];
}

std::array<float, 3> vectorColor(const glm::vec2& direction, float saturation) {
  constexpr float kGray = kCyclicLightness * kCyclicLightness * kCyclicLightness;
  const float turn = std::atan2(direction.y, direction.x) / (2.0f * std::numbers::pi_v<float>);
  std::array<float, 3> color = mapColor(ColorMap::Cyclic, turn - std::floor(turn));
  for (float& channel : color) channel = kGray + saturation * (channel - kGray);
  return color;
}

} // namespace taa
