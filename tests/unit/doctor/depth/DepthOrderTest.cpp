// What hides what, on painted frames and on pixels set by hand.
#include "core/doctor/depth/DepthOrder.h"

#include "core/doctor/frames/Regions.h"
#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace taa::doctor {
namespace {

using Change = std::function<void(DoctorFrame&)>;

/// Of 6 frames of the shot, each changed.
DepthOrder orderOf(const test::PaintedShot& shot, const Change& change = {}) {
  DepthOrder out;
  RegionTracker tracker;
  DoctorFrame before;
  std::vector<RegionIndex> labelsBefore;
  for (int frame = 0; frame < 6; ++frame) {
    DoctorFrame now = test::paintedFrame(shot, frame);
    if (change) change(now);
    std::vector<RegionIndex> labels = tracker.label(now);
    if (frame > 0) out.add(now, before, labels, labelsBefore);
    before = std::move(now);
    labelsBefore = std::move(labels);
  }
  return out;
}

void changeDepth(DoctorFrame& frame, const std::function<float(float)>& change) {
  for (float& depth : frame.depth.pixels) depth = change(depth);
}

} // namespace

// A board moves before a ground that rests. A pixel of the ground counts whose place of a frame ago, which
// has the ground's motion, lies between four pixels of the board.
TEST(DepthOrder, AgreesWhereTheBoardIsNearer) {
  const DepthOrder order = orderOf({.cameraPx = {0.0, 0.0}, .boardPx = {8.0, 0.0}, .isJittered = false});
  // The strip that it leaves is 8 px wide and 36 high; below the last row there is none of the board. Five
  // pairs.
  EXPECT_EQ(order.nearer, 5u * 8 * 35);
  EXPECT_EQ(order.farther, 0u);
  EXPECT_EQ(order.frames, 5);
  EXPECT_EQ(order.verdict(), OrderVerdict::Agrees);
}

TEST(DepthOrder, IsReversedWhereDepthGrowsWithTheDistance) {
  for (const auto& stored :
       {std::function<float(float)>([](float depth) { return 1.0f - depth; }),
        std::function<float(float)>([](float depth) { return 0.001f / (depth + 0.001f); })}) {
    const DepthOrder order =
        orderOf({.boardPx = {8.0, 0.0}}, [&](DoctorFrame& frame) { changeDepth(frame, stored); });
    EXPECT_EQ(order.nearer, 0u);
    EXPECT_EQ(order.verdict(), OrderVerdict::Reversed) << order.farther;
    EXPECT_EQ(order.reversedShare(), 1.0);
  }
}

// A board without its own motion, or with motion the other way, comes from where the ground was on one side
// and leaves the ground on the other: both orders are met.
TEST(DepthOrder, IsUnclearWhereMotionIsWrong) {
  for (const float factor : {0.0f, -1.0f}) {
    const DepthOrder order =
        orderOf({.cameraPx = {0.0, 0.0}, .boardPx = {8.0, 0.0}}, [&](DoctorFrame& frame) {
          test::changeMotion(frame, test::kBoardId, [&](const glm::vec2& motion) { return factor * motion; });
        });
    EXPECT_EQ(order.verdict(), OrderVerdict::Unclear) << order.nearer << ' ' << order.farther;
  }
}

// Without numbers regions are parts that end where depth or motion does: on a ground that is looked along,
// anywhere.
TEST(DepthOrder, SaysNothingOfPartsWithoutNumbers) {
  const DepthOrder order =
      orderOf({.boardPx = {8.0, 0.0}}, [](DoctorFrame& frame) { frame.objectId.clear(); });
  EXPECT_EQ(order.pixels(), 0u);
}

TEST(DepthOrder, SaysNothingWhereNothingComesOut) {
  EXPECT_EQ(orderOf({.boardPx = {0.0, 0.0}}).verdict(), OrderVerdict::TooFew);
  const DepthOrder flat = orderOf({.boardPx = {8.0, 0.0}}, [](DoctorFrame& frame) {
    changeDepth(frame, [](float depth) { return depth > 0.0f ? 0.01f : 0.0f; });
  });
  EXPECT_EQ(flat.pixels(), 0u) << "of one depth";
}

} // namespace taa::doctor
