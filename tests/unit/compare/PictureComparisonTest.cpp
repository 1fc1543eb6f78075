// What is made of two pictures, and that a part of a map is that of the whole.
#include "core/measure/PictureComparison.h"

#include "core/base/Error.h"
#include "core/measure/compare/Flip.h"
#include "core/measure/compare/HdrFlip.h"
#include "core/measure/compare/RelativeError.h"
#include "core/measure/compare/Sharpness.h"
#include "core/measure/compare/Ssim.h"
#include "tests/unit/compare/Pictures.h"

#include <gtest/gtest.h>

#include <optional>
#include <string_view>

using taa::Image;
using taa::IntermediateId;
using taa::Metric;
using taa::PictureComparison;
using namespace taa::test;

namespace {

constexpr int kWide = 50, kHigh = 34;

Image pattern(float scale) {
  return pictureOf(kWide, kHigh, [scale](int x, int y) { return scale * patternColor(x, y); });
}

PictureComparison compared() {
  return {pattern(0.5f), pattern(1.0f)};
}

} // namespace

TEST(PictureComparison, GivesTheNumbersOfBothPictures) {
  PictureComparison both = compared();
  const taa::PictureError error = taa::pictureError(pattern(0.5f), pattern(1.0f));
  const Image shown = taa::shownColors(pattern(0.5f)), reference = taa::shownColors(pattern(1.0f));
  EXPECT_EQ(both.metric(Metric::Rmse), error.rmse);
  EXPECT_EQ(both.metric(Metric::Psnr), error.psnr);
  EXPECT_EQ(both.metric(Metric::RmseLinear), error.rmseLinear);
  EXPECT_EQ(both.metric(Metric::RelativeMse), taa::relativeMse(pattern(0.5f), pattern(1.0f)));
  EXPECT_EQ(both.metric(Metric::Sharpness), taa::sharpness(shown, reference));
  EXPECT_NEAR(*both.metric(Metric::Ssim), taa::meanSsim(taa::ssimMap(shown, reference)), 1e-7);
  EXPECT_EQ(both.metric(Metric::Flip), meanOf(taa::flipMap(pattern(0.5f), pattern(1.0f))));
  EXPECT_EQ(both.metric(Metric::HdrFlip), meanOf(taa::hdrFlipMap(pattern(0.5f), pattern(1.0f))));
}

TEST(PictureComparison, GivesANumberForEachMetricOfTwoPictures) {
  PictureComparison both = compared();
  for (const taa::MetricInfo& info : taa::kMetrics)
    if (taa::isOfPictures(info.metric)) {
      EXPECT_TRUE(both.metric(info.metric)) << info.id;
    }
  PictureComparison flat{flatPicture(4, 4, glm::vec3(0.5f)), flatPicture(4, 4, glm::vec3(0.25f))};
  EXPECT_FALSE(flat.metric(Metric::Sharpness)) << "there is no edge";
}

TEST(PictureComparison, MapsAreDarkWhereAllIsAsItShouldBe) {
  PictureComparison same{pattern(1.0f), pattern(1.0f)};
  for (const IntermediateId id : {IntermediateId::flip, IntermediateId::ssimMap})
    for (const float value : same.map(id).pixels) ASSERT_EQ(value, 0.0f) << taa::intermediate(id).name;
  PictureComparison both = compared();
  EXPECT_EQ(both.map(IntermediateId::flip).pixels, taa::flipMap(pattern(0.5f), pattern(1.0f)).pixels);
  const Image alike = taa::ssimMap(taa::shownColors(pattern(0.5f)), taa::shownColors(pattern(1.0f)));
  EXPECT_EQ(*both.map(IntermediateId::ssimMap).at(20, 7), 1.0f - *alike.at(20, 7));
}

// In the middle, in a corner, and once the whole map is there.
TEST(PictureComparison, APartOfAMapIsThatOfTheWhole) {
  for (const IntermediateId id : {IntermediateId::flip, IntermediateId::ssimMap}) {
    PictureComparison whole = compared();
    const Image& map = whole.map(id);
    for (const glm::ivec2 first : {glm::ivec2(22, 15), glm::ivec2(0, 0), glm::ivec2(kWide - 3, kHigh - 2)})
      for (const Image& part : {compared().mapPart(id, first, {3, 2}), whole.mapPart(id, first, {3, 2})})
        for (int y = 0; y < 2; ++y)
          for (int x = 0; x < 3; ++x)
            ASSERT_EQ(*part.at(x, y), *map.at(first.x + x, first.y + y))
                << taa::intermediate(id).name << " at " << first.x + x << ", " << first.y + y;
  }
}

TEST(PictureComparison, ACostlyNumberIsMadeOnce) {
  PictureComparison both = compared();
  int asked = 0;
  const auto count = [&asked](std::string_view, int, int) { return ++asked > 0; };
  EXPECT_THROW(both.metric(Metric::HdrFlip, [](std::string_view, int, int) { return false; }),
               taa::Cancelled);
  const std::optional<double> number = both.metric(Metric::HdrFlip, count);
  EXPECT_GT(asked, 0) << "what was cancelled is made when it is asked for again";
  asked = 0;
  EXPECT_EQ(both.metric(Metric::HdrFlip, count), number);
  EXPECT_EQ(asked, 0);
}
