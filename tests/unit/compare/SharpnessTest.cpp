// Sharpness of edges made by hand.
#include "core/measure/compare/Sharpness.h"

#include "tests/unit/compare/Pictures.h"

#include <gtest/gtest.h>

#include <map>

using taa::Image;
using taa::sharpness;
using namespace taa::test;

namespace {

constexpr int kWide = 24, kHigh = 9;

/// 0.25 to the left of column 12, 0.75 from there on, but for some columns.
Image edge(const std::map<int, float>& columns = {}) {
  return pictureOf(kWide, kHigh, [&](int x, int) {
    const auto found = columns.find(x);
    return glm::vec3(found != columns.end() ? found->second : x < 12 ? 0.25f : 0.75f);
  });
}

} // namespace

TEST(Sharpness, IsOneOfTheSamePicture) {
  EXPECT_DOUBLE_EQ(sharpness(edge(), edge()).value(), 1.0);
  EXPECT_DOUBLE_EQ(sharpness(stepPicture(kWide, kHigh, 5), stepPicture(kWide, kHigh, 5)).value(), 1.0);
}

TEST(Sharpness, FallsWithBlur) {
  // Blurred over three pixels the gradient is a third of the step where it was half of it.
  const Image blurred = edge({{11, 0.25f + 0.5f / 3.0f}, {12, 0.25f + 1.0f / 3.0f}});
  EXPECT_NEAR(sharpness(blurred, edge()).value(), 2.0 / 3.0, 1e-6);
  EXPECT_NEAR(sharpness(flatPicture(kWide, kHigh, glm::vec3(0.5f)), edge()).value(), 0.0, 1e-6);
}

TEST(Sharpness, IsAboveOneWhereAnEdgeIsOverdrawn) {
  EXPECT_NEAR(sharpness(edge({{11, 0.15f}, {12, 0.85f}}), edge()).value(), 1.2, 1e-6)
      << "0.6 over two pixels instead of 0.5";
}

TEST(Sharpness, IsHalfWhereTheEdgeStandsAPixelBesideItsPlace) {
  EXPECT_NEAR(sharpness(edge({{12, 0.25f}}), edge()).value(), 0.5, 1e-6);
}

TEST(Sharpness, LooksAtEdgesOfTheReferenceAlone) {
  EXPECT_FALSE(sharpness(edge(), flatPicture(kWide, kHigh, glm::vec3(0.5f))))
      << "there is nothing to compare with";
  const auto ramp = [](float perPixel) {
    return pictureOf(kWide, kHigh, [perPixel](int x, int) { return glm::vec3(perPixel * float(x)); });
  };
  EXPECT_FALSE(sharpness(ramp(0.03f), ramp(0.04f))) << "too flat for an edge";
  EXPECT_NEAR(sharpness(ramp(0.03f), ramp(0.06f)).value(), 0.5, 1e-6) << "a gradient is the slope of a ramp";
  EXPECT_NEAR(sharpness(edge({{3, 1.0f}}), edge()).value(), 1.0, 1e-6)
      << "what is sharp elsewhere is not asked";
}

TEST(Sharpness, IsTheSameInAllDirections) {
  const auto slope = [](float x, float y) {
    return pictureOf(12, 12, [=](int px, int py) { return glm::vec3(0.1f + x * float(px) + y * float(py)); });
  };
  // Inside; at the border the outermost pixels go on, and a ramp is half as steep.
  const double along = sharpness(slope(0.06f, 0.0f), slope(0.06f, 0.0f)).value();
  EXPECT_DOUBLE_EQ(along, 1.0);
  EXPECT_NEAR(sharpness(slope(0.0f, 0.06f), slope(0.06f, 0.0f)).value(), 1.0, 0.1);
}
