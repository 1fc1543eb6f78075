// Which checkpoints are given up first.
#include "core/inspect/Checkpoints.h"

#include <gtest/gtest.h>

#include <numeric>

namespace {

std::vector<int> framesUpTo(int last) {
  std::vector<int> frames(static_cast<std::size_t>(last) + 1);
  std::iota(frames.begin(), frames.end(), 0);
  return frames;
}

/// What is left of `frames` when only `count` can be kept.
std::vector<int> left(std::vector<int> frames, std::size_t count, int playhead, int stride) {
  while (frames.size() > count) {
    const std::optional<int> frame = taa::frameToGiveUp(frames, playhead, stride);
    if (!frame) break;
    std::erase(frames, *frame);
  }
  return frames;
}

} // namespace

TEST(Checkpoints, GiveUpTheFarthestFromThePlayhead) {
  EXPECT_EQ(taa::frameToGiveUp(std::vector<int>{1, 2, 3, 9}, 3, 100), 9);
  EXPECT_EQ(taa::frameToGiveUp(std::vector<int>{1, 5, 6, 7}, 7, 100), 1);
}

TEST(Checkpoints, KeepAnchorsOverTheWholeShot) {
  EXPECT_EQ(left(framesUpTo(40), 8, 40, 10), (std::vector<int>{0, 10, 20, 30, 37, 38, 39, 40}));
  EXPECT_EQ(left(framesUpTo(40), 8, 21, 10), (std::vector<int>{0, 10, 20, 21, 22, 23, 30, 40}));
}

TEST(Checkpoints, GiveUpAnchorsWhenNothingElseIsLeft) {
  EXPECT_EQ(taa::frameToGiveUp(std::vector<int>{0, 10, 20}, 20, 10), 0);
}

TEST(Checkpoints, NeverGiveUpThePlayheadNorTheFrameBeforeIt) {
  EXPECT_EQ(taa::frameToGiveUp(std::vector<int>{7, 8}, 8, 1), std::nullopt);
  EXPECT_EQ(left(framesUpTo(9), 0, 5, 3), (std::vector<int>{4, 5}));
}

TEST(Checkpoints, HandHistoriesOutAndTakeThemBack) {
  taa::HistoryPool pool;
  taa::Checkpoints checkpoints;
  std::shared_ptr<taa::History> history = pool.take();
  const taa::History* address = history.get();
  checkpoints.keep(3, std::move(history));
  EXPECT_EQ(checkpoints.at(3).get(), address);
  EXPECT_EQ(checkpoints.at(4), nullptr);
  checkpoints.clear();
  EXPECT_EQ(pool.take().get(), address) << "used again";
}

TEST(Checkpoints, MayOutliveTheirPool) {
  taa::Checkpoints checkpoints;
  {
    taa::HistoryPool pool;
    checkpoints.keep(0, pool.take());
  }
  EXPECT_EQ(checkpoints.bytes(), 0u);
  checkpoints.clear();
  EXPECT_EQ(checkpoints.size(), 0u);
}
