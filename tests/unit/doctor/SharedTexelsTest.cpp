// Planes of values that change from texel to texel, and pixels that share these.
#include "core/doctor/frames/SharedTexels.h"

#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <optional>

namespace taa::doctor {
namespace {

using Value = std::function<float(int x, int y)>;

SharedTexels texelsOf(const glm::ivec2& sizePx, int channels, const Value& value) {
  Image plane(sizePx.x, sizePx.y, channels);
  for (int y = 0; y < sizePx.y; ++y)
    for (int x = 0; x < sizePx.x; ++x)
      for (int c = 0; c < channels; ++c) plane.at(x, y)[c] = value(x, y) + static_cast<float>(c);
  SharedTexels out;
  out.add(plane);
  return out;
}

/// 0 to 65535, another one for each place.
float noise(int x, int y) {
  std::uint32_t word = static_cast<std::uint32_t>(x) * 2654435761u + static_cast<std::uint32_t>(y) * 40503u;
  word = (word ^ (word >> 15)) * 2246822519u;
  return static_cast<float>((word ^ (word >> 13)) & 0xFFFFu);
}

std::optional<int> sideOf(int shared, const glm::ivec2& sizePx = {160, 96}, int channels = 1) {
  return texelsOf(sizePx, channels, [shared](int x, int y) { return noise(x / shared, y / shared); }).side();
}

} // namespace

TEST(SharedTexels, HaveTheSideOfTheirSquares) {
  EXPECT_EQ(sideOf(1), std::nullopt);
  for (const int side : {2, 3, 4}) EXPECT_EQ(sideOf(side), side);
  EXPECT_EQ(sideOf(2, {160, 96}, 2), 2) << "of two channels";
  for (const int side : {2, 3, 4}) EXPECT_EQ(sideOf(side, {960, 540}), side) << "of each seventh row";
}

TEST(SharedTexels, AreNoneWhereNothingChanges) {
  EXPECT_EQ(texelsOf({160, 96}, 1, [](int, int) { return 0.5f; }).side(), std::nullopt);
  // Surfaces of one depth, whose silhouettes lie anywhere.
  const auto cards = [](int x, int y) { return noise(x / 7, y / 5); };
  EXPECT_EQ(texelsOf({160, 96}, 1, cards).side(), std::nullopt);
}

// What rounding makes equal here and there lies in no squares.
TEST(SharedTexels, AreNoneWhereValuesAreRounded) {
  const auto rounded = [](int x, int y) { return static_cast<float>((3 * x + 2 * y) / 5); };
  EXPECT_EQ(texelsOf({160, 96}, 1, rounded).side(), std::nullopt);
}

} // namespace taa::doctor
