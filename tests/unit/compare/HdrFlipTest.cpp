// HDR-FLIP of pictures made by hand; values with six digits or more as in FlipTest.cpp.
#include "core/measure/compare/HdrFlip.h"

#include "core/base/Error.h"
#include "core/measure/compare/Flip.h"
#include "tests/unit/compare/Pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

using taa::flipExposures;
using taa::hdrFlipMap;
using taa::Image;
using namespace taa::test;

namespace {

/// 0 to 16, most of it dark.
Image highlights() {
  return pictureOf(24, 16, [](int x, int y) {
    const glm::vec3 color = patternColor(x, y);
    return 16.0f * color * color * color;
  });
}

Image cutOff(Image image, float most) {
  for (float& value : image.pixels) value = std::min(value, most);
  return image;
}

} // namespace

TEST(HdrFlip, ToneMapsAsAces) {
  EXPECT_EQ(taa::acesToneMapped(0.0f), 0.0f);
  EXPECT_EQ(taa::acesToneMapped(-1.0f), 0.0f);
  EXPECT_NEAR(taa::acesToneMapped(1.0f), (0.9036 + 0.018) / (0.8748 + 0.354 + 0.14), 1e-6);
  EXPECT_NEAR(taa::acesToneMapped(2.118872324f), 0.85, 1e-6);
  EXPECT_EQ(taa::acesToneMapped(65504.0f), 1.0f) << "0.9036 / 0.8748, cut off";
}

TEST(HdrFlip, LooksFromTheBrightestToTheMedianOfTheReference) {
  const std::vector<double> exposures = flipExposures(highlights());
  ASSERT_EQ(exposures.size(), 3u) << "2.3 stops";
  EXPECT_NEAR(exposures[0], -2.9167033415, 1e-6);
  EXPECT_NEAR(exposures[1], 0.5 * (-2.9167033415 - 0.6135397274), 1e-6);
  EXPECT_NEAR(exposures[2], -0.6135397274, 1e-6);
  EXPECT_EQ(flipExposures(flatPicture(4, 4, glm::vec3(2.0f))).size(), 2u) << "two at least";
  EXPECT_NEAR(flipExposures(flatPicture(4, 4, glm::vec3(2.0f)))[1], std::log2(2.118872324 / 2.0), 1e-6);
}

TEST(HdrFlip, LooksAtWhatIsNotBlackWhereMostIs) {
  EXPECT_EQ(flipExposures(flatPicture(4, 4, glm::vec3(0.0f))), (std::vector<double>{0.0}));
  Image night = flatPicture(4, 4, glm::vec3(0.0f));
  std::fill_n(night.at(0, 0), 3, 8.0f);
  std::fill_n(night.at(1, 0), 3, 2.0f);
  std::fill_n(night.at(2, 0), 3, 1.0f);
  const std::vector<double> exposures = flipExposures(night);
  ASSERT_EQ(exposures.size(), 2u);
  EXPECT_NEAR(exposures[0], std::log2(2.118872324 / 8.0), 1e-6);
  EXPECT_NEAR(exposures[1], std::log2(2.118872324 / 2.0), 1e-6);
}

TEST(HdrFlip, IsTheLargestOfAllExposures) {
  const Image map = hdrFlipMap(cutOff(highlights(), 2.0f), highlights());
  EXPECT_NEAR(meanOf(map), 0.5447824693, 2e-6);
  EXPECT_NEAR(*map.at(0, 0), 0.5740139708, 2e-6);
  EXPECT_NEAR(*map.at(12, 8), 0.5136504176, 2e-6);
  EXPECT_NEAR(*map.at(23, 15), 0.6353385011, 2e-6);
}

TEST(HdrFlip, SeesWhatAScreenCutsOff) {
  EXPECT_EQ(meanOf(taa::flipMap(cutOff(highlights(), 2.0f), highlights())), 0.0) << "both are white there";
  EXPECT_NEAR(meanOf(hdrFlipMap(flatPicture(4, 4, glm::vec3(1.0f)), flatPicture(4, 4, glm::vec3(2.0f)))),
              0.2328200836, 2e-6);
  EXPECT_EQ(meanOf(hdrFlipMap(highlights(), highlights())), 0.0);
}

TEST(HdrFlip, EndsWhenNobodyWantsIt) {
  int asked = 0;
  const auto stop = [&asked](std::string_view, int done, int total) {
    EXPECT_EQ(total, 3);
    EXPECT_EQ(done, asked);
    return ++asked < 2;
  };
  EXPECT_THROW(hdrFlipMap(highlights(), highlights(), stop), taa::Cancelled);
  EXPECT_EQ(asked, 2);
}
