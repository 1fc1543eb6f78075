// Numbers of light against those of their standards, and pictures read between pixels.
#include "core/base/Light.h"

#include "core/base/Image.h"

#include <gtest/gtest.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cmath>

using namespace taa;

TEST(Light, OfWhiteIsOneAndOfAPrimaryItsShare) {
  EXPECT_DOUBLE_EQ(luminance(glm::dvec3(1.0)), 1.0);
  EXPECT_EQ(luminance(glm::vec3(1.0f, 0.0f, 0.0f)), 0.2126f);
  EXPECT_EQ(luminance(glm::vec3(0.0f, 1.0f, 0.0f)), 0.7152f);
  EXPECT_EQ(luminance(glm::dvec3(0.0, 0.0, 1.0)), 0.0722);
}

// IEC 61966-2-1: half of the light is 187.516 of 255, and the two pieces of the curve meet.
TEST(Light, FollowsTheCurveOfSrgb) {
  EXPECT_NEAR(255.0 * srgbEncoded(0.5), 187.516, 1e-3);
  EXPECT_DOUBLE_EQ(srgbEncoded(0.001), 0.01292);
  EXPECT_DOUBLE_EQ(srgbEncoded(-0.001), -0.01292);
  EXPECT_NEAR(srgbEncoded(0.0031308), srgbEncoded(0.0031309), 2e-6);
  for (int code = 0; code <= 255; ++code)
    EXPECT_NEAR(srgbEncoded(srgbDecoded(code / 255.0)), code / 255.0, 1e-7);
  EXPECT_EQ(shownLight(-2.0), 0.0);
  EXPECT_NEAR(shownLight(20.0), 1.0, 1e-15);
  EXPECT_EQ(srgbByte(0.5f), 188);
  EXPECT_EQ(srgbByte(20.0f), 255);
  EXPECT_EQ(srgbByte(-1.0f), 0);
  EXPECT_EQ(srgbByte(std::nanf("")), 0);
}

TEST(Image, IsReadBetweenPixelsAndBeyondItsBorder) {
  Image image(2, 2, 1);
  image.pixels = {1.0f, 2.0f, 3.0f, 5.0f};
  const auto read = [&](float x, float y) {
    return bilinear(glm::vec2(x, y), [&](int column, int row) { return *image.nearest(column, row); });
  };
  EXPECT_EQ(read(0.5f, 0.5f), 1.0f);
  EXPECT_EQ(read(1.5f, 1.5f), 5.0f);
  EXPECT_EQ(read(1.0f, 0.5f), 1.5f);
  EXPECT_EQ(read(1.0f, 1.0f), 2.75f);
  EXPECT_EQ(read(-7.0f, 9.0f), 3.0f) << "the nearest at the border";
  EXPECT_EQ(*image.nearest(-1, 0), 1.0f);
  EXPECT_EQ(*image.nearest(9, 1), 5.0f);
}
