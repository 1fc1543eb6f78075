// FLIP of pictures made by hand. Values with six digits or more are from a computation in 64-bit floats that
// follows the paper line by line, with whole filters instead of products.
#include "core/measure/compare/Flip.h"

#include "tests/unit/compare/Pictures.h"

#include <gtest/gtest.h>

#include <algorithm>

using taa::flipMap;
using taa::Image;
using namespace taa::test;

namespace {

constexpr int kWide = 24, kHigh = 16;
// FLIP takes the root of differences of features: the rounding of 32-bit floats, 1e-8, may come to 1e-4 where
// they cancel; away from there it stays below this.
constexpr double kRounding = 2e-6;

double flipOfFlat(const glm::vec3& picture, const glm::vec3& reference) {
  const Image map = flipMap(flatPicture(4, 3, picture), flatPicture(4, 3, reference));
  EXPECT_EQ(std::ranges::count(map.pixels, map.pixels[0]), 12) << "every pixel is the same";
  return double(map.pixels[0]);
}

Image pattern(float scale = 1.0f, float offset = 0.0f) {
  return pictureOf(kWide, kHigh, [=](int x, int y) { return patternColor(x, y) * scale + offset; });
}

} // namespace

TEST(Flip, IsNothingBetweenTheSamePictures) {
  for (const float value : flipMap(pattern(), pattern()).pixels) ASSERT_EQ(value, 0.0f);
}

TEST(Flip, OfFlatPicturesIsThatOfTheirColors) {
  EXPECT_NEAR(flipOfFlat(glm::vec3(1.0f), glm::vec3(0.0f)), 0.9673797628, kRounding);
  EXPECT_NEAR(flipOfFlat(glm::vec3(0.25f), glm::vec3(0.5f)), 0.4518496251, kRounding);
  EXPECT_NEAR(flipOfFlat({0.5f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}), 0.7290356749, kRounding);
  EXPECT_NEAR(flipOfFlat({0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}), 1.0, kRounding)
      << "green and blue are furthest apart";
}

TEST(Flip, SeesAnEdgeThatIsAPixelBesideItsPlace) {
  const Image map = flipMap(stepPicture(kWide, kHigh, 13), stepPicture(kWide, kHigh, 12));
  EXPECT_NEAR(meanOf(map), 0.1379267409, 1e-5);
  EXPECT_NEAR(*map.at(12, 8), 0.5381737537, 1e-4) << "between the edges their strengths cancel";
  EXPECT_NEAR(*map.at(9, 8), 0.3575661822, kRounding);
  EXPECT_EQ(*map.at(0, 8), 0.0f) << "12 px away";
}

TEST(Flip, SeesLessContrast) {
  const Image map = flipMap(pattern(0.75f, 0.0625f), pattern());
  EXPECT_NEAR(meanOf(map), 0.1896708805, kRounding);
  EXPECT_NEAR(*map.at(0, 0), 0.1784094499, kRounding) << "outside, the outermost pixels go on";
  EXPECT_NEAR(*map.at(12, 8), 0.1703168145, kRounding);
  EXPECT_NEAR(*map.at(23, 15), 0.2688710791, kRounding);
}

TEST(Flip, SeesAMissingPoint) {
  const Image flat = flatPicture(kWide, kHigh, glm::vec3(0.1f));
  Image dot = flat;
  std::fill_n(dot.at(12, 8), 3, 0.5f);
  const Image map = flipMap(flat, dot);
  EXPECT_NEAR(meanOf(map), 0.0091872321, kRounding);
  EXPECT_NEAR(*map.at(12, 8), 0.3201526204, kRounding);
  EXPECT_NEAR(*map.at(14, 8), 0.1034094468, kRounding);
}

TEST(Flip, IsTheSameBothWaysRound) {
  EXPECT_EQ(flipMap(pattern(0.5f), pattern()).pixels, flipMap(pattern(), pattern(0.5f)).pixels);
}

TEST(Flip, IsOfWhatAScreenShows) {
  const Image map = flipMap(flatPicture(4, 3, {4.0f, 1.0f, -2.0f}), flatPicture(4, 3, {1.0f, 1.0f, 0.0f}));
  EXPECT_EQ(meanOf(map), 0.0) << "above white and below black nothing is seen";
}

TEST(Flip, OfAPartThatIsLargerByItsReachIsThatOfTheWhole) {
  const int reach = taa::flipReach();
  EXPECT_EQ(reach, 10) << "three deviations of the widest filter, at 67 pixels per degree";
  const auto crop = [reach](const Image& image) {
    return pictureOf(2 * reach + 2, image.height,
                     [&](int x, int y) { return glm::vec3(image.texel(30 - reach + x, y)); });
  };
  const auto wide = [](float scale) {
    return pictureOf(64, 40, [scale](int x, int y) { return scale * patternColor(x, y); });
  };
  const Image whole = flipMap(wide(0.5f), wide(1.0f)), part = flipMap(crop(wide(0.5f)), crop(wide(1.0f)));
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 2; ++x) ASSERT_EQ(*part.at(reach + x, y), *whole.at(30 + x, y)) << x << ", " << y;
}

TEST(Flip, SeesMoreOfAPatternThatIsNearer) {
  EXPECT_GT(meanOf(flipMap(pattern(0.5f), pattern(), 20.0)), 1.05 * meanOf(flipMap(pattern(0.5f), pattern())))
      << "20 pixels per degree are not blurred as 67 are";
}
