// When thumbnails may be drawn: in a fixed order, at most four times a second each, and only where time is
// left.
#include "core/jobs/idle/ThumbnailSchedule.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <set>

using taa::IntermediateId;
using taa::Stage;
using taa::ThumbnailSchedule;
using namespace std::chrono_literals;

namespace {

using Time = ThumbnailSchedule::Clock::time_point;
constexpr Time kStart{10s};

ThumbnailSchedule wanted() {
  ThumbnailSchedule schedule;
  schedule.want({96, 54});
  return schedule;
}

} // namespace

TEST(MainRows, AreRowsOfTheirStages) {
  std::size_t stages = 0;
  for (const taa::StageInfo& stage : taa::kStages) {
    if (stage.main.empty()) continue;
    ++stages;
    const auto row = taa::mainRow(stage.stage);
    ASSERT_TRUE(row) << stage.main;
    EXPECT_EQ(taa::intermediate(*row).stage, stage.stage) << stage.main;
    // It is shown as a fraction of its texture's size, which is not the picture's where that is a thumbnail.
    EXPECT_NE(taa::intermediate(*row).visual, taa::Visual::Position) << stage.main;
  }
  EXPECT_EQ(taa::mainRows().size(), stages);
  EXPECT_EQ(stages, taa::kStages.size() - 3) << "jitter and faults have no picture, the reference not always";
}

TEST(ThumbnailSchedule, DrawsNothingThatNobodyWants) {
  ThumbnailSchedule schedule;
  EXPECT_FALSE(schedule.dueAt(1, kStart));
  schedule.want({96, 54});
  EXPECT_TRUE(schedule.dueAt(1, kStart));
  schedule.want({0, 0});
  EXPECT_FALSE(schedule.dueAt(1, kStart));
}

TEST(ThumbnailSchedule, DrawsEachOnceAFrameWhenItHasSettled) {
  ThumbnailSchedule schedule = wanted();
  const auto due = schedule.dueAt(1, kStart);
  ASSERT_TRUE(due);
  EXPECT_GT(*due, kStart);
  EXPECT_LE(*due, kStart + 250ms);
  EXPECT_EQ(schedule.dueAt(2, kStart + 100ms).value() - due.value(), 100ms) << "another frame: wait anew";
  std::set<IntermediateId> rows;
  Time now = kStart + 1s;
  while (schedule.dueAt(2, now)) {
    EXPECT_LE(*schedule.dueAt(2, now), now) << "its values are at hand";
    rows.insert(schedule.next());
    schedule.drawn(now, now + 1ms);
    now += 1ms;
    ASSERT_LE(rows.size(), taa::mainRows().size());
  }
  EXPECT_EQ(rows.size(), taa::mainRows().size());
  EXPECT_TRUE(schedule.dueAt(3, now)) << "a new frame";
}

TEST(ThumbnailSchedule, DrawsEachFourTimesASecondAtMostWhilePlaying) {
  ThumbnailSchedule schedule = wanted();
  const IntermediateId first = schedule.next();
  int drawn = 0;
  std::uint64_t version = 1;
  for (Time now = kStart; now < kStart + 2s; now += 1ms) {
    if ((now - kStart) % 16ms == 0ms) ++version; // a frame
    const auto due = schedule.dueAt(version, now, now + 10ms);
    if (!due || *due > now) continue;
    drawn += schedule.next() == first ? 1 : 0;
    schedule.drawn(now, now + 1ms);
  }
  EXPECT_GE(drawn, 6);
  EXPECT_LE(drawn, 9);
}

TEST(ThumbnailSchedule, LeavesTheNextFrameItsTime) {
  ThumbnailSchedule schedule = wanted();
  EXPECT_FALSE(schedule.dueAt(1, kStart, kStart + 1ms));
  EXPECT_TRUE(schedule.dueAt(1, kStart, kStart + 10ms));
  schedule.drawn(kStart, kStart + 4ms);
  const Time next = kStart + 100ms;
  EXPECT_FALSE(schedule.dueAt(2, next, next + 6ms)) << "the last one took four";
  EXPECT_TRUE(schedule.dueAt(2, next, next + 9ms));
  EXPECT_FALSE(schedule.dueAt(2, next, next - 5ms)) << "the frame is late";
}
