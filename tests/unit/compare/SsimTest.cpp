// SSIM of pictures made by hand. Values with six digits or more are from a computation in 64-bit floats that
// follows the paper line by line.
#include "core/measure/compare/Ssim.h"

#include "tests/unit/compare/Pictures.h"

#include <gtest/gtest.h>

using taa::Image;
using taa::meanSsim;
using taa::ssimMap;
using namespace taa::test;

namespace {

constexpr int kWide = 20, kHigh = 16;
constexpr double kRounding = 1e-5; // variances are differences of 32-bit floats near 1: 1e-7 of C2, 9e-4

Image pattern(int shiftPx = 0) {
  return pictureOf(kWide, kHigh, [shiftPx](int x, int y) {
    return x < shiftPx ? patternColor(x - shiftPx + 1001, y) : patternColor(x - shiftPx, y);
  });
}

Image flat(float value) {
  return flatPicture(kWide, kHigh, glm::vec3(value));
}

Image mapped(Image image, float scale, float offset) {
  for (float& value : image.pixels) value = scale * value + offset;
  return image;
}

} // namespace

TEST(Ssim, IsOneBetweenTheSamePictures) {
  for (const float value : ssimMap(pattern(), pattern()).pixels) ASSERT_EQ(value, 1.0f);
}

TEST(Ssim, OfFlatPicturesIsThatOfTheirMeans) {
  EXPECT_NEAR(meanSsim(ssimMap(flat(0.25f), flat(0.5f))), (2 * 0.125 + 1e-4) / (0.0625 + 0.25 + 1e-4), 1e-6);
  EXPECT_NEAR(meanSsim(ssimMap(flat(0.0f), flat(1.0f))), 1e-4 / (1.0 + 1e-4), 1e-6);
}

TEST(Ssim, FallsWithContrastAndTurnsAroundInTheNegative) {
  const Image half = ssimMap(mapped(pattern(), 0.5f, 0.25f), pattern());
  EXPECT_NEAR(meanSsim(half), 0.8025649791, kRounding);
  EXPECT_NEAR(*half.at(10, 8), 0.8027256360, kRounding);
  EXPECT_NEAR(*half.at(0, 0), 0.7617837846, kRounding) << "outside, the outermost pixels go on";
  const Image negative = ssimMap(mapped(pattern(), -1.0f, 1.0f), pattern());
  EXPECT_NEAR(meanSsim(negative), -0.9835634781, kRounding);
  EXPECT_NEAR(*negative.at(10, 8), -0.9820517942, kRounding);
}

TEST(Ssim, OfAShiftedPatternHasNothingOfIt) {
  const Image map = ssimMap(pattern(1), pattern());
  EXPECT_NEAR(meanSsim(map), -0.4127088339, kRounding);
  EXPECT_NEAR(*map.at(10, 8), -0.4132713181, kRounding);
}

TEST(Ssim, IsTheMeanOverWholeWindows) {
  Image map(12, 11, 1);
  map.pixels.assign(map.pixels.size(), -1.0f);
  *map.at(5, 5) = 0.25f;
  *map.at(6, 5) = 0.75f;
  EXPECT_EQ(meanSsim(map), 0.5) << "two pixels are five away from every side";
  map = Image(10, 40, 1);
  map.pixels.assign(map.pixels.size(), 0.125f);
  EXPECT_EQ(meanSsim(map), 0.125) << "no window lies in it: all pixels";
}
