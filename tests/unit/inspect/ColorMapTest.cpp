// The color maps: their known colors, and what makes them fit for data.
#include "core/picture/ColorMap.h"

#include "core/base/Light.h"
#include "core/picture/OkLab.h"
#include "core/picture/ViewRequest.h"

#include <glm/vec3.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>

namespace {

using taa::ColorMap;
using taa::mapColor;
using Rgb = std::array<float, 3>;

std::array<int, 3> bytes(const Rgb& color) {
  std::array<int, 3> out{};
  for (std::size_t channel = 0; channel < 3; ++channel)
    out[channel] = static_cast<int>(std::lround(255.0f * taa::srgbEncoded(color[channel])));
  return out;
}

void expectNear(const Rgb& color, const std::array<int, 3>& expected, int tolerance) {
  for (std::size_t channel = 0; channel < 3; ++channel)
    EXPECT_NEAR(bytes(color)[channel], expected[channel], tolerance) << "channel " << channel;
}

/// OKLab (B. Ottosson, 2020): lightness 0 black to 1 white, green to red, blue to yellow.
Rgb oklab(const Rgb& c) {
  const float l = std::cbrt(0.4122214708f * c[0] + 0.5363325363f * c[1] + 0.0514459929f * c[2]);
  const float m = std::cbrt(0.2119034982f * c[0] + 0.6806995451f * c[1] + 0.1073969566f * c[2]);
  const float s = std::cbrt(0.0883024619f * c[0] + 0.2817188376f * c[1] + 0.6299787005f * c[2]);
  return {0.2104542553f * l + 0.7936177850f * m - 0.0040720468f * s,
          1.9779984951f * l - 2.4285922050f * m + 0.4505937099f * s,
          0.0259040371f * l + 0.7827717662f * m - 0.8086757660f * s};
}

float lightness(const Rgb& color) {
  return oklab(color)[0];
}

float distance(const Rgb& a, const Rgb& b) {
  const Rgb from = oklab(a), to = oklab(b);
  return std::hypot(from[0] - to[0], from[1] - to[1], from[2] - to[2]);
}

Rgb seen(const std::array<Rgb, 3>& eye, const Rgb& color) {
  Rgb out{};
  for (std::size_t row = 0; row < 3; ++row)
    out[row] =
        std::clamp(eye[row][0] * color[0] + eye[row][1] * color[1] + eye[row][2] * color[2], 0.0f, 1.0f);
  return out;
}

} // namespace

TEST(ColorMap, HasAnEntryForEveryMapAndStaysInRange) {
  const taa::Image& table = taa::colorMapTable();
  EXPECT_EQ(table.width, taa::kColorMapEntries);
  EXPECT_EQ(table.height, taa::kColorMapCount);
  for (float value : table.pixels) EXPECT_TRUE(value >= 0.0f && value <= 1.0f) << value;
}

TEST(ColorMap, GraySpreadsEvenlyOverTheBytesOfTheScreen) {
  for (int byte = 0; byte < 256; ++byte)
    expectNear(mapColor(ColorMap::Gray, static_cast<float>(byte) / 255.0f), {byte, byte, byte}, 0);
}

TEST(ColorMap, HasTheKnownColorsOfViridisAndInferno) {
  expectNear(mapColor(ColorMap::Viridis, 0.0f), {0x44, 0x01, 0x54}, 0);
  expectNear(mapColor(ColorMap::Viridis, 1.0f), {0xfd, 0xe7, 0x25}, 0);
  expectNear(mapColor(ColorMap::Inferno, 0.0f), {0x00, 0x00, 0x04}, 0);
  expectNear(mapColor(ColorMap::Inferno, 1.0f), {0xfc, 0xff, 0xa4}, 0);
  // The middle lies between two of the stops; 4 of 255 is what a cubic through ten of them may miss by.
  expectNear(mapColor(ColorMap::Viridis, 0.5f), {0x21, 0x91, 0x8c}, 4);
  expectNear(mapColor(ColorMap::Inferno, 0.5f), {0xbc, 0x37, 0x54}, 4);
}

TEST(ColorMap, GetsLighterAllTheWayWhereItShowsMagnitudes) {
  for (ColorMap map : {ColorMap::Gray, ColorMap::Viridis, ColorMap::Inferno})
    for (int step = 1; step <= 64; ++step)
      EXPECT_GT(lightness(mapColor(map, static_cast<float>(step) / 64.0f)),
                lightness(mapColor(map, static_cast<float>(step - 1) / 64.0f)))
          << taa::colorMapName(map) << " at " << step << "/64";
}

TEST(ColorMap, IsNeutralInTheMiddleOfTheDivergingMap) {
  const Rgb middle = mapColor(ColorMap::Diverging, 0.5f);
  EXPECT_EQ(middle[0], middle[1]);
  EXPECT_EQ(middle[1], middle[2]);
  EXPECT_GT(mapColor(ColorMap::Diverging, 0.0f)[2], mapColor(ColorMap::Diverging, 0.0f)[0]) << "blue below";
  EXPECT_GT(mapColor(ColorMap::Diverging, 1.0f)[0], mapColor(ColorMap::Diverging, 1.0f)[2]) << "orange above";
}

TEST(ColorMap, IsEquallyLightAtEqualDistanceFromTheMiddle) {
  for (int step = 0; step <= 16; ++step) {
    const float distance = static_cast<float>(step) / 32.0f;
    // 0.01 of lightness: where blue is clamped to what a screen can show.
    EXPECT_NEAR(lightness(mapColor(ColorMap::Diverging, 0.5f - distance)),
                lightness(mapColor(ColorMap::Diverging, 0.5f + distance)), 0.01f)
        << distance;
  }
}

TEST(ColorMap, KeepsItsLightnessAllAroundTheCycle) {
  for (int step = 0; step < 64; ++step)
    // 0.002: linear steps between entries 1.4 degrees of hue apart, and the rounding of OKLab's matrices.
    EXPECT_NEAR(lightness(mapColor(ColorMap::Cyclic, static_cast<float>(step) / 64.0f)),
                taa::kCyclicLightness, 0.002f)
        << step;
  EXPECT_EQ(mapColor(ColorMap::Cyclic, 0.0f), mapColor(ColorMap::Cyclic, 1.0f));
  EXPECT_EQ(mapColor(ColorMap::Cyclic, 0.25f), mapColor(ColorMap::Cyclic, -0.75f));
}

TEST(ColorMap, ColorsVectorsByDirectionAndLength) {
  EXPECT_EQ(taa::vectorColor({0.0f, 2.0f}, 1.0f), mapColor(ColorMap::Cyclic, 0.25f));
  EXPECT_EQ(taa::vectorColor({-1.0f, 0.5f}, 0.0f), taa::vectorColor({1.0f, 0.0f}, 0.0f)) << "gray";
}

TEST(ColorMap, TellsCategoriesApartByLightnessToo) {
  for (int a = 0; a < taa::kCategoryCount; ++a)
    for (int b = a + 1; b < taa::kCategoryCount; ++b)
      EXPECT_GT(std::abs(lightness(taa::categoryColor(a)) - lightness(taa::categoryColor(b))), 0.04f)
          << a << " and " << b;
}

// Every reject reason has a color of its own, for eyes that lack one kind of cones too (the matrices of G. M.
// Machado and others, 2009, for the whole lack, on linear Rec. 709).
TEST(ColorMap, TellsReasonsApartForAllEyes) {
  ASSERT_GE(taa::kCategoryCount, taa::kReasonCount);
  using Matrix = std::array<Rgb, 3>;
  constexpr Matrix kEyes[] = {{{{1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}}},
                              {{{0.152286f, 1.052583f, -0.204868f},
                                {0.114503f, 0.786281f, 0.099216f},
                                {-0.003882f, -0.048116f, 1.051998f}}},
                              {{{0.367322f, 0.860646f, -0.227968f},
                                {0.280085f, 0.672501f, 0.047413f},
                                {-0.011820f, 0.042940f, 0.968881f}}},
                              {{{1.255528f, -0.076749f, -0.178779f},
                                {-0.078411f, 0.930809f, 0.147602f},
                                {0.004733f, 0.691367f, 0.303900f}}}};
  for (std::size_t eye = 0; eye < std::size(kEyes); ++eye)
    for (int a = 0; a < taa::kReasonCount; ++a)
      for (int b = a + 1; b < taa::kReasonCount; ++b)
        // Of OKLab; 0.02 is about the least that eyes tell apart side by side.
        EXPECT_GT(distance(seen(kEyes[eye], taa::categoryColor(a)), seen(kEyes[eye], taa::categoryColor(b))),
                  0.055f)
            << a << " and " << b << " for eye " << eye;
}

TEST(ColorMap, KeepsTheFirstCategoryForZero) {
  EXPECT_EQ(taa::categoryColor(1), taa::categoryColor(10));
  EXPECT_EQ(taa::categoryColor(9), taa::categoryColor(18));
  EXPECT_NE(taa::categoryColor(0), taa::categoryColor(10));
  EXPECT_EQ(mapColor(ColorMap::Categorical, 0.0f), taa::categoryColor(0));
  EXPECT_EQ(mapColor(ColorMap::Categorical, 1.0f), taa::categoryColor(9));
}

TEST(OkLab, IsThereAndBackAndWhiteIsOne) {
  const glm::vec3 white = taa::okLabOf(glm::vec3(1.0f));
  EXPECT_NEAR(white.x, 1.0f, 1e-4f);
  EXPECT_NEAR(white.y, 0.0f, 1e-4f);
  EXPECT_NEAR(white.z, 0.0f, 1e-4f);
  for (const glm::vec3& color : {glm::vec3(0.5f, 0.1f, 0.2f), glm::vec3(0.02f, 0.7f, 0.3f)}) {
    const Rgb twin = oklab({color.x, color.y, color.z});
    const glm::vec3 lab = taa::okLabOf(color), back = taa::linearOfOkLab(lab);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(lab[i], twin[static_cast<std::size_t>(i)], 1e-6f);
      EXPECT_NEAR(back[i], color[i], 1e-4f);
    }
  }
}

TEST(ColorMap, ClampsWhatLiesOutside) {
  EXPECT_EQ(mapColor(ColorMap::Viridis, -3.0f), mapColor(ColorMap::Viridis, 0.0f));
  EXPECT_EQ(mapColor(ColorMap::Viridis, 7.0f), mapColor(ColorMap::Viridis, 1.0f));
  EXPECT_EQ(mapColor(ColorMap::Viridis, std::numeric_limits<float>::quiet_NaN()),
            mapColor(ColorMap::Viridis, 0.0f));
}
