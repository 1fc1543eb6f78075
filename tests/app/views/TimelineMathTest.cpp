// Frames on the ruler of the timeline.
#include "app/views/timeline/TimelineMath.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

using namespace taa::app;

TEST(TimelineMath, EveryFrameIsFoundWhereItIsDrawn) {
  for (const int count : {1, 2, 7, 240, 2000}) {
    const TimelineScale scale{count, 12.0, 701.0};
    for (int frame = 0; frame < count; ++frame) EXPECT_EQ(scale.frameAt(scale.position(frame)), frame);
  }
}

TEST(TimelineMath, EndsHoldOutside) {
  const TimelineScale scale{240, 10.0, 478.0};
  EXPECT_EQ(scale.frameAt(-1e9), 0);
  EXPECT_EQ(scale.frameAt(1e9), 239);
  EXPECT_EQ(scale.position(239), 488.0);
  EXPECT_EQ((TimelineScale{1, 0.0, 100.0}).frameAt(70), 0);
}

TEST(TimelineMath, APartOfTheShotFillsTheRuler) {
  const TimelineScale scale{240, 10.0, 400.0, Span{60.0, 80.0}};
  EXPECT_EQ(scale.position(60), 10.0);
  EXPECT_EQ(scale.position(70), 210.0);
  EXPECT_EQ(scale.position(80), 410.0);
  EXPECT_EQ(scale.frameAt(210.0), 70);
  EXPECT_EQ(scale.frameAt(-1e9), 0) << "a drag beyond the end goes on";
  EXPECT_EQ(scale.ticks(10), (std::vector<int>{60, 70, 80}));
  EXPECT_EQ(scale.ticks(8), (std::vector<int>{64, 72, 80}));
}

TEST(TimelineMath, TicksAreRoundAndFarEnoughApart) {
  const TimelineScale scale{240, 0.0, 478.0}; // 2 px a frame
  EXPECT_EQ(scale.tickStep(2.0), 1);
  EXPECT_EQ(scale.tickStep(3.0), 2);
  EXPECT_EQ(scale.tickStep(40.0), 20);
  EXPECT_EQ(scale.tickStep(41.0), 50);
  EXPECT_EQ(scale.ticks(100), (std::vector<int>{0, 100, 200}));
}

TEST(Timeline, NeighboringFramesAreARun) {
  using Runs = std::vector<std::pair<int, int>>;
  EXPECT_EQ(runsOfFrames({1, 2, 3, 7, 9, 10}), (Runs{{1, 3}, {7, 7}, {9, 10}}));
  EXPECT_EQ(runsOfFrames({}), Runs());
}

TEST(Timeline, AnEndOfARangePushesTheOther) {
  EXPECT_EQ(withEnd({10, 20}, false, 15), std::pair(15, 20));
  EXPECT_EQ(withEnd({10, 20}, false, 25), std::pair(25, 25));
  EXPECT_EQ(withEnd({10, 20}, true, 5), std::pair(5, 5));
}
