// Worst pixels of pictures made by hand.
#include "core/verdict/parts/WorstPixels.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <limits>
#include <utility>
#include <vector>

using taa::Image;
using taa::WorstPixel;

namespace {

/// 16 × 8, 0 but where it is said.
Image picture(std::initializer_list<std::pair<glm::ivec2, float>> values) {
  Image image(16, 8, 1);
  for (const auto& [pixel, value] : values) *image.at(pixel.x, pixel.y) = value;
  return image;
}

} // namespace

TEST(WorstPixels, AreLocalMaximaWorstFirst) {
  const Image bad = picture({{{2, 2}, 1.0f}, {{3, 2}, 0.9f}, {{10, 5}, 2.0f}, {{14, 1}, 0.5f}});
  EXPECT_EQ(taa::worstPixels(bad, 8, 0),
            (std::vector<WorstPixel>{{{10, 5}, 2.0f}, {{2, 2}, 1.0f}, {{14, 1}, 0.5f}}))
      << "what lies on the slope of another is none";
  EXPECT_EQ(taa::worstPixels(bad, 1, 0), (std::vector<WorstPixel>{{{10, 5}, 2.0f}}));
  EXPECT_TRUE(taa::worstPixels(picture({}), 8, 0).empty());
}

TEST(WorstPixels, AreApart) {
  const Image bad = picture({{{2, 2}, 1.0f}, {{5, 4}, 0.9f}, {{6, 2}, 0.8f}});
  EXPECT_EQ(taa::worstPixels(bad, 8, 3), (std::vector<WorstPixel>{{{2, 2}, 1.0f}, {{6, 2}, 0.8f}}))
      << "(5, 4) lies within 3 of a worse one, which (6, 2) does not";
  EXPECT_EQ(taa::worstPixels(bad, 8, 1).size(), 3u);
}

TEST(WorstPixels, OfEqualOnesAreTheUpperThenTheLeft) {
  const Image bad = picture({{{9, 6}, 1.0f}, {{12, 1}, 1.0f}, {{3, 6}, 1.0f}});
  const std::vector<WorstPixel> worst = taa::worstPixels(bad, 8, 1);
  EXPECT_EQ(worst, (std::vector<WorstPixel>{{{12, 1}, 1.0f}, {{3, 6}, 1.0f}, {{9, 6}, 1.0f}}));
  Image plateau(16, 8, 1);
  plateau.pixels.assign(plateau.pixels.size(), 0.25f);
  EXPECT_EQ(taa::worstPixels(plateau, 2, 4), (std::vector<WorstPixel>{{{0, 0}, 0.25f}, {{5, 0}, 0.25f}}));
}

TEST(WorstPixels, OfSignedValuesAreTheLargestAmounts) {
  Image row(2, 1, 3);
  row.pixels = {0.5f, -0.75f, 0.0f, std::numeric_limits<float>::quiet_NaN(), 0.25f, -0.125f};
  EXPECT_EQ(taa::amounts(row).pixels, (std::vector<float>{0.75f, 0.25f}));
}

TEST(WorstPixels, OfACategoryAreItsOwnEvenWhereNothingIsWrong) {
  const Image categories = picture({{{1, 1}, 2.0f}, {{8, 4}, 2.0f}, {{4, 4}, 3.0f}});
  const Image error = picture({{{8, 4}, -0.5f}, {{4, 4}, 9.0f}, {{12, 6}, 7.0f}});
  const std::vector<WorstPixel> worst = taa::worstPixels(taa::ofCategory(categories, 2, error), 8, 1);
  ASSERT_EQ(worst.size(), 2u);
  EXPECT_EQ(worst[0], (WorstPixel{{8, 4}, 0.5f}));
  EXPECT_EQ(worst[1].pixel, glm::ivec2(1, 1));
}
