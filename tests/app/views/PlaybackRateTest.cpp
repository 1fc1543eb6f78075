// Frames a second while a shot plays.
#include "app/panels/TimelinePanel.h"

#include <gtest/gtest.h>

using taa::app::PlaybackRate;

TEST(PlaybackRate, IsOfTheLastSecond) {
  PlaybackRate rate;
  EXPECT_FALSE(rate.value());
  for (int frame = 0; frame < 10; ++frame) rate.note(frame, 0.5 * frame);
  EXPECT_DOUBLE_EQ(*rate.value(), 2.0);
  for (int frame = 10; frame < 60; ++frame) rate.note(frame, 4.5 + 0.125 * (frame - 9));
  EXPECT_DOUBLE_EQ(*rate.value(), 8.0) << "what was before does not slow it";
}

TEST(PlaybackRate, IsThatOfTheLastTwoWhereTheyAreSlower) {
  PlaybackRate rate;
  rate.note(3, 10.0);
  rate.note(3, 11.0);
  EXPECT_FALSE(rate.value()) << "one frame, said twice";
  rate.note(4, 14.0);
  rate.note(5, 18.0);
  EXPECT_DOUBLE_EQ(*rate.value(), 0.25);
  rate.stop();
  EXPECT_FALSE(rate.value());
}
