// Numbers of rows over time that are made by hand.
#include "core/measure/RowsOverTime.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using taa::Image;
using taa::IntermediateId;
using taa::Metric;
using taa::RowImages;

namespace {

Image row(const std::vector<float>& values) {
  Image image(static_cast<int>(values.size()), 1, 1);
  image.pixels = values;
  return image;
}

} // namespace

TEST(RowsOverTime, FlickersNumberIsTheMeanOfWhatWasSeenBefore) {
  RowImages rows{{IntermediateId::flicker, row({0.5f, 0.25f, 0.75f})},
                 {IntermediateId::framesFollowed, row({1.0f, 2.0f, 16.0f})}};
  EXPECT_EQ(taa::metricOverTime(Metric::Flicker, rows), 0.5);
  rows[IntermediateId::framesFollowed] = row({1.0f, 1.0f, 1.0f});
  EXPECT_FALSE(taa::metricOverTime(Metric::Flicker, rows));
}

TEST(RowsOverTime, GhostsNumberIsTheRootOfTheirMeanSquare) {
  RowImages rows{{IntermediateId::ghost, row({0.0f, 0.5f})},
                 {IntermediateId::framesFollowed, row({1.0f, 2.0f})}};
  EXPECT_EQ(taa::metricOverTime(Metric::GhostEnergy, rows), std::sqrt(0.125)) << "what was hidden counts";
  rows[IntermediateId::framesFollowed] = row({1.0f, 1.0f});
  EXPECT_FALSE(taa::metricOverTime(Metric::GhostEnergy, rows)) << "nothing was seen before";
}
