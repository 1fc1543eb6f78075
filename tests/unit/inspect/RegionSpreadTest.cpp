// How the values of a region are spread: of values whose figures are known by hand.
#include "core/picture/RegionSpread.h"
#include "core/picture/RegionSpreadText.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace taa;

namespace {

Image column(int channels, std::vector<float> pixels) {
  Image image(1, static_cast<int>(pixels.size()) / channels, channels);
  image.pixels = std::move(pixels);
  return image;
}

const Intermediate& kScalar = intermediate(IntermediateId::alpha);

} // namespace

TEST(RegionSpread, TellsWhatIsNoNumberFromValues) {
  const Image values = column(1, {1, 2, 3, 6, NAN, INFINITY, -INFINITY});
  const RegionSpread spread = regionSpread(values, {}, kScalar, {0, 0, 1, 7});
  ASSERT_EQ(spread.channels.size(), 1u);
  const ChannelSpread& of = spread.channels[0];
  EXPECT_EQ(of.count, 4);
  EXPECT_EQ(of.nan, 1);
  EXPECT_EQ(of.infinite, 2);
  EXPECT_EQ(of.absent, 0);
  EXPECT_EQ(of.min, 1.0f);
  EXPECT_EQ(of.max, 6.0f);
  EXPECT_EQ(of.mean, 3.0);
  EXPECT_DOUBLE_EQ(of.deviation, std::sqrt((4.0 + 1.0 + 0.0 + 9.0) / 4.0));
  EXPECT_EQ(of.percentiles[3], 2.0f) << "the median: two of four are not above it";
}

TEST(RegionSpread, NoPreviousPositionAndAbsenceAreNoValues) {
  const Intermediate& motion = intermediate(IntermediateId::motion);
  const RegionSpread moved = regionSpread(column(2, {1, 2, 65504, 65504}), {}, motion, {0, 0, 1, 2});
  EXPECT_EQ(moved.channels[0].absent, 1);
  EXPECT_EQ(moved.channels[1].max, 2.0f);
  const RegionSpread partly = regionSpread(column(1, {1, NAN}), column(1, {0, 6}), kScalar, {0, 0, 1, 2});
  EXPECT_EQ(partly.channels[0].absent, 1);
  EXPECT_EQ(partly.channels[0].nan, 0) << "there ought to be none";
}

TEST(RegionSpread, ARegionWithoutAValueHasNoFigures) {
  const RegionSpread spread = regionSpread(column(1, {NAN, NAN}), {}, kScalar, {0, 0, 1, 2});
  EXPECT_EQ(spread.channels[0].count, 0);
  EXPECT_TRUE(spread.counts.empty());
  EXPECT_EQ(spreadLines(spread, kScalar, {})[0][1], "—");
  EXPECT_FALSE(spreadJson(spread, kScalar, {})["channels"][0].contains("min"));
}

TEST(RegionSpread, NumbersThatStandForSomethingAreCountedOneByOne) {
  const Intermediate& reasons = intermediate(IntermediateId::rejectReason);
  const RegionSpread spread = regionSpread(column(1, {0, 4, 0, 0}), {}, reasons, {3, 4, 1, 4});
  EXPECT_EQ(spread.categories, (std::vector<std::pair<int, int>>{{0, 3}, {4, 1}}));
  EXPECT_EQ(categoriesText(spread, reasons), "0 kept 75 % (3), 4 depth 25 % (1)");
}

// Half of what is above 0 in the first 32nd: a fan with a highlight of 26.
TEST(RegionSpread, AnAxisIsLogarithmicWhereValuesCrowd) {
  std::vector<float> values(100, 0.1f);
  values.push_back(26.0f);
  const HistogramAxis wide = axisOf(values, kScalar, {});
  EXPECT_TRUE(wide.isLogarithmic);
  EXPECT_GT(wide.low, 0.0f);
  EXPECT_EQ(wide.valueAt(0.0), 0.0) << "its left end stands for 0, too";
  EXPECT_NEAR(wide.valueAt(wide.placeOf(3.0)), 3.0, 1e-6);
  EXPECT_EQ(wide.placeOf(0.0), 0.0);
  EXPECT_FALSE(axisOf(values, intermediate(IntermediateId::referenceError), {}).isLogarithmic)
      << "of what can be negative";
  values.push_back(-0.5f);
  EXPECT_FALSE(axisOf(values, kScalar, {}).isLogarithmic) << "of what is";
  EXPECT_FALSE(axisOf({0.5f, 1.0f}, kScalar, {}).isLogarithmic);
}

TEST(RegionSpread, AnAxisOfOneValueHasAWidth) {
  for (const float value : {0.0f, 0.5f, 3e6f, -2.0f}) {
    const HistogramAxis axis = axisOf({value, value}, kScalar, {});
    EXPECT_LT(axis.low, axis.high) << value;
    EXPECT_EQ(countedOn(axis, {value, value},
                        4)[static_cast<std::size_t>(axis.placeOf(static_cast<double>(value)) * 4)],
              2)
        << value;
  }
}

TEST(RegionSpread, ARegionIsReadInTheWaysThatPeopleWriteIt) {
  const gl::Rect region{12, 8, 40, 30};
  for (const char* text : {"12,8,40x30", "12, 8, 40×30", "12 8 40 30"})
    EXPECT_EQ(parseRegion(text), std::optional(region)) << text;
  for (const char* text : {"", "12,8", "12,8,0x30", "a,8,40x30", "1,2,3,4,5", "-1,2,3,4"})
    EXPECT_FALSE(parseRegion(text)) << text;
  EXPECT_EQ(insidePicture({50, 20, 40, 40}, 64, 36), (gl::Rect{50, 20, 14, 16}));
  EXPECT_FALSE(insidePicture({64, 0, 4, 4}, 64, 36));
}
