// How far a footprint reaches, how old a sample is, and the way on the screen.
#include "app/models/verdict/LineageMath.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

using namespace taa;
using namespace taa::app;

namespace {

Lineage threeFrames() {
  Lineage lineage;
  lineage.frame = 7;
  lineage.frames.resize(3);
  for (int age = 0; age < 3; ++age) {
    LineageFrame& entry = lineage.frames[static_cast<std::size_t>(age)];
    entry.frame = 7 - age;
    entry.place = {10.5 - age, 4.5};
  }
  lineage.frames[0].weight = 0.5;
  lineage.frames[0].rectified = 0.25;
  lineage.frames[1].weight = 0.2;
  lineage.frames[2].weight = -0.05;
  return lineage;
}

} // namespace

TEST(LineageMath, AFootprintReachesToTheLastSampleThatCounts) {
  EXPECT_EQ(footprintReach({}), 0.75);
  std::vector<FootprintSample> samples{{.offset = {0.1, -0.3}, .weight = 0.5}};
  EXPECT_EQ(footprintReach(samples), 0.75);
  samples.push_back({.offset = {-1.2, 0.0}, .weight = 0.006});
  EXPECT_EQ(footprintReach(samples), 1.5);
  samples.push_back({.offset = {0.0, 7.0}, .weight = -0.005});
  EXPECT_EQ(footprintReach(samples), 8.0) << "one that counts against the others counts";
  samples.push_back({.offset = {30.0, 0.0}, .weight = 0.004});
  EXPECT_EQ(footprintReach(samples), 8.0) << "less than a hundredth of the heaviest";
  samples.push_back({.offset = {100.5, 0.0}, .weight = 0.5});
  EXPECT_EQ(footprintReach(samples), 101.0);
}

TEST(LineageMath, AgesGoFromThisFrameToTheOldest) {
  const Lineage lineage = threeFrames();
  EXPECT_EQ(ageShare(lineage, 7), 0.0);
  EXPECT_EQ(ageShare(lineage, 6), 0.5);
  EXPECT_EQ(ageShare(lineage, 5), 1.0);
  Lineage one = lineage;
  one.frames.resize(1);
  EXPECT_EQ(ageShare(one, 7), 0.0);
}

TEST(LineageMath, BarsHoldSamplesAndWhatRectificationPutOnThem) {
  EXPECT_EQ(barSpan(threeFrames()), (Span{-0.05, 0.75}));
  EXPECT_EQ(barSpan({}), (Span{0.0, 0.0}));
}

TEST(LineageMath, TheWayEndsWhereNothingCounts) {
  Lineage lineage = threeFrames();
  const std::vector<PathPlace> path = pathOf(lineage);
  ASSERT_EQ(path.size(), 3u);
  EXPECT_EQ(path[2], (PathPlace{{8.5, 4.5}, -0.05}));
  lineage.frames[2].weight = 0.0009;
  EXPECT_EQ(pathOf(lineage).size(), 2u);
  EXPECT_TRUE(pathOf({}).empty());
}
