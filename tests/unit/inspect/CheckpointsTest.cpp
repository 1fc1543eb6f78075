// Which checkpoints are given up first.
#include "core/replay/Checkpoints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace {

std::vector<int> framesUpTo(int last) {
  std::vector<int> frames(static_cast<std::size_t>(last) + 1);
  std::iota(frames.begin(), frames.end(), 0);
  return frames;
}

/// What is left of `frames` when only `count` can be kept.
std::vector<int> left(std::vector<int> frames, std::size_t count, const taa::Spread& spread) {
  while (frames.size() > count) {
    const std::optional<int> frame = taa::frameToGiveUp(frames, spread);
    if (!frame) break;
    std::erase(frames, *frame);
  }
  return frames;
}

taa::Shot shotOf(int frames, std::vector<int> cuts = {}) {
  taa::Shot shot;
  shot.frames = frames;
  shot.cuts = std::move(cuts);
  return shot;
}

/// What is kept once a shot was played, of `capacity` frames.
std::vector<int> played(const taa::Shot& shot, std::size_t capacity) {
  std::vector<int> kept;
  for (int frame = 0; frame < shot.frames; ++frame) {
    kept.push_back(frame);
    kept = left(kept, capacity, taa::spreadOver(shot, capacity, frame));
  }
  return kept;
}

bool holds(const std::vector<int>& kept, int frame) {
  return std::ranges::binary_search(kept, frame);
}

/// How many frames are resolved to be at `frame`: none when it and the one before are kept.
int distance(const std::vector<int>& kept, const taa::Shot& shot, int frame) {
  const auto starts = [&](int at) { return at == 0 || std::ranges::find(shot.cuts, at) != shot.cuts.end(); };
  if (holds(kept, frame) && (starts(frame) || holds(kept, frame - 1))) return 0;
  int count = 1;
  for (; !starts(frame) && !holds(kept, frame - 1); --frame) ++count;
  return count;
}

} // namespace

TEST(Checkpoints, GiveUpTheFarthestFromThePlayhead) {
  EXPECT_EQ(taa::frameToGiveUp(std::vector<int>{1, 2, 3, 9}, {.playhead = 3, .stride = 100, .ends = {}}), 9);
  EXPECT_EQ(taa::frameToGiveUp(std::vector<int>{1, 5, 6, 7}, {.playhead = 7, .stride = 100, .ends = {}}), 1);
}

TEST(Checkpoints, KeepSomeOverTheWholeShot) {
  EXPECT_EQ(left(framesUpTo(40), 8, {.playhead = 40, .stride = 10, .ends = {}}),
            (std::vector<int>{0, 10, 20, 30, 37, 38, 39, 40}));
  EXPECT_EQ(left(framesUpTo(40), 8, {.playhead = 21, .stride = 10, .ends = {}}),
            (std::vector<int>{0, 10, 20, 21, 22, 23, 30, 40}));
}

TEST(Checkpoints, KeepTheEndsTheLongest) {
  const taa::Spread spread{.playhead = 5, .stride = 4, .ends = {0, 23, 38, 39}};
  EXPECT_EQ(left(framesUpTo(39), 6, spread), (std::vector<int>{0, 4, 5, 23, 38, 39}));
  EXPECT_EQ(left(framesUpTo(39), 4, spread), (std::vector<int>{0, 4, 5, 23}));
}

TEST(Checkpoints, CountCutsAmongTheEndsWhileThereAreFew) {
  const taa::Shot few = shotOf(240, {60, 180});
  EXPECT_EQ(taa::spreadOver(few, 72, 9).ends, (std::vector<int>{60, 180, 0, 238, 239}));
  const taa::Shot many = shotOf(240, {2, 3, 5, 7, 11, 13, 17, 19, 23, 29});
  EXPECT_EQ(taa::spreadOver(many, 36, 9).ends, (std::vector<int>{0, 238, 239}));
}

TEST(Checkpoints, SpreadHalfOfThemOverTheShot) {
  EXPECT_EQ(taa::spreadOver(shotOf(240), 72, 0).stride, 7);
  EXPECT_EQ(taa::spreadOver(shotOf(240), 1000, 0).stride, 1);
  EXPECT_EQ(taa::spreadOver(shotOf(240), 1, 0).stride, 240);
  EXPECT_EQ(taa::spreadOver(shotOf(1), 0, 0).stride, 1);
}

TEST(Checkpoints, GiveUpAnchorsWhenNothingElseIsLeft) {
  EXPECT_EQ(taa::frameToGiveUp(std::vector<int>{0, 10, 20}, {.playhead = 20, .stride = 10, .ends = {}}), 0);
}

TEST(Checkpoints, NeverGiveUpThePlayheadNorTheFrameBeforeIt) {
  const taa::Spread spread{.playhead = 8, .stride = 1, .ends = {7, 8}};
  EXPECT_EQ(taa::frameToGiveUp(std::vector<int>{7, 8}, spread), std::nullopt);
  EXPECT_EQ(left(framesUpTo(9), 0, {.playhead = 5, .stride = 3, .ends = {}}), (std::vector<int>{4, 5}));
}

// 1 GiB holds 72 histories of 1280 × 720 with the default settings, 16 bytes a pixel.
TEST(Checkpoints, BringEveryFrameOfAPlayedShotWithinSixteenFrames) {
  static_assert((std::size_t(1) << 30) / (1280 * 720 * 16) == 72);
  for (const taa::Shot& shot : {shotOf(240), shotOf(240, {60, 100, 180})}) {
    for (const std::size_t capacity : {std::size_t{36}, std::size_t{72}}) {
      const std::vector<int> kept = played(shot, capacity);
      EXPECT_LE(kept.size(), capacity);
      std::vector<int> distances;
      for (int frame = 0; frame < shot.frames; ++frame) distances.push_back(distance(kept, shot, frame));
      std::ranges::sort(distances);
      EXPECT_LE(distances.back(), 16);
      EXPECT_LE(distances[distances.size() / 2], 8);
      for (const int end : {0, shot.frames - 1}) EXPECT_EQ(distance(kept, shot, end), 0) << end;
      for (const int cut : shot.cuts) EXPECT_EQ(distance(kept, shot, cut), 0) << cut;
    }
  }
}

TEST(Checkpoints, HoldSixteenFramesBehindThePlayhead) {
  const taa::Shot shot = shotOf(240);
  std::vector<int> kept;
  for (int frame = 0; frame < shot.frames; ++frame) {
    kept.push_back(frame);
    kept = left(kept, 72, taa::spreadOver(shot, 72, frame));
    for (int back = 0; back <= std::min(16, frame); ++back)
      EXPECT_EQ(distance(kept, shot, frame - back), 0) << back << " behind " << frame;
  }
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
