// Which range shows the values at hand.
#include "app/views/legend/RangeMath.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

using namespace taa;
using namespace taa::app;

namespace {

Image valuesOf(int channels, std::vector<float> pixels) {
  Image image(static_cast<int>(pixels.size()) / channels, 1, channels);
  image.pixels = std::move(pixels);
  return image;
}

std::optional<ValueRange> rangeOf(const Image& values, const Intermediate& row, const ViewStyle& style = {}) {
  return autoRange(shownValues(values, row, style), row);
}

const Intermediate& kAlpha = intermediate(IntermediateId::alpha);
const Intermediate& kColor = intermediate(IntermediateId::color);
const Intermediate& kMotion = intermediate(IntermediateId::motion);

} // namespace

TEST(RangeMath, GoesFromTheFirstToTheNinetyNinthPercentileOfFiniteValues) {
  EXPECT_EQ(rangeOf(valuesOf(1, {0.5f, NAN, 0.25f, INFINITY, -INFINITY, 0.75f}), kAlpha),
            (ValueRange{0.25f, 0.75f}));
  std::vector<float> many(1000, 0.5f);
  for (int index = 0; index < 15; ++index) many[static_cast<std::size_t>(index)] = 0.0164f;
  for (int index = 15; index < 30; ++index) many[static_cast<std::size_t>(index)] = 1.0f;
  many[999] = 26.0f; // a highlight of one pixel leaves the others their contrast
  EXPECT_EQ(rangeOf(valuesOf(1, many), kAlpha), (ValueRange{0.0164f, 1.0f}));
}

TEST(RangeMath, GoesFromTheLeastToTheGreatestWhereNearlyAllValuesAreTheSame) {
  std::vector<float> many(1000, 0.0f);
  many[7] = 0.75f;
  EXPECT_EQ(rangeOf(valuesOf(1, many), kAlpha), (ValueRange{0.0f, 0.75f}));
}

TEST(RangeMath, HasNoAnswerWithoutValues) {
  EXPECT_FALSE(rangeOf(valuesOf(1, {NAN, INFINITY}), kAlpha));
  EXPECT_FALSE(rangeOf({}, kAlpha));
}

TEST(RangeMath, CountsShownChannelsOnly) {
  ViewStyle style;
  style.green = style.blue = false;
  EXPECT_EQ(rangeOf(valuesOf(3, {1, 50, 60, 2, 70, 80}), kColor, style), (ValueRange{1, 2}));
}

TEST(RangeMath, IsSymmetricForVectorsAndSkipsWhatHasNoPrevious) {
  EXPECT_EQ(rangeOf(valuesOf(2, {-3, 1, 65504, 65504, 2, 0}), kMotion), (ValueRange{-3, 3}));
}

TEST(RangeMath, IsNeverEmpty) {
  EXPECT_EQ(rangeOf(valuesOf(1, {2, 2}), kAlpha), (ValueRange{2, 3}));
}

TEST(RangeMath, AnAxisHasRoomForTheValuesAndTheRange) {
  const Image values = valuesOf(1, {1, 2, NAN, 2, 5});
  const Distribution narrow = distributionOf(values, kAlpha, {}, {}, 4);
  EXPECT_EQ(narrow.values, (ValueRange{1, 5}));
  EXPECT_FLOAT_EQ(narrow.axis.low, 0.8f);
  EXPECT_FLOAT_EQ(narrow.axis.high, 5.2f);
  EXPECT_EQ(narrow.counts, (std::vector<int>{1, 2, 0, 1}));
  const Distribution wide = distributionOf(values, kAlpha, {}, ValueRange{-5, 4}, 0);
  EXPECT_FLOAT_EQ(wide.axis.low, -5.5f);
  EXPECT_FLOAT_EQ(wide.axis.high, 5.5f);
  EXPECT_TRUE(wide.counts.empty());
  EXPECT_FLOAT_EQ(distributionOf({}, kAlpha, {}, ValueRange{0, 10}, 0).axis.high, 10.5f) << "no value";
}

TEST(RangeMath, AnAxisOfValuesThatCannotBeNegativeBeginsAtZero) {
  const Image values = valuesOf(1, {0, 0.5f, 1});
  EXPECT_EQ(distributionOf(values, kAlpha, {}, {}, 0).axis.low, 0.0f);
  EXPECT_LT(distributionOf(values, intermediate(IntermediateId::referenceError), {}, {}, 0).axis.low, 0.0f);
}

TEST(RangeMath, ColorMapsAreForSingleChannels) {
  ViewStyle style;
  EXPECT_TRUE(usesColorMap(kAlpha, style));
  EXPECT_FALSE(usesColorMap(kColor, style));
  setShown(style, 0, false);
  setShown(style, 2, false);
  EXPECT_TRUE(usesColorMap(kColor, style));
  EXPECT_FALSE(hasRange(intermediate(IntermediateId::rejectReason)));
  EXPECT_TRUE(hasExposure(kColor));
  EXPECT_FALSE(hasExposure(kAlpha));
}

TEST(RangeMath, ADifferenceOpensWithAQuarterOfTheRangeBothWays) {
  const ViewStyle style = differenceStyle(kMotion);
  EXPECT_EQ(style.high, 8.0f);
  EXPECT_EQ(style.low, -8.0f);
  EXPECT_EQ(style.map, ColorMap::Diverging);
}
