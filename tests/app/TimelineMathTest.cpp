// Frames on the ruler of the timeline.
#include "app/views/TimelineMath.h"

#include <gtest/gtest.h>

using taa::app::TimelineScale;

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

TEST(TimelineMath, TicksAreRoundAndFarEnoughApart) {
  const TimelineScale scale{240, 0.0, 478.0}; // 2 px a frame
  EXPECT_EQ(scale.tickStep(2.0), 1);
  EXPECT_EQ(scale.tickStep(3.0), 2);
  EXPECT_EQ(scale.tickStep(40.0), 20);
  EXPECT_EQ(scale.tickStep(41.0), 50);
  EXPECT_EQ(scale.ticks(100), (std::vector<int>{0, 100, 200}));
}
