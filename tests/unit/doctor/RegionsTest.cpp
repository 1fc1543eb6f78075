// Pictures are split into the regions that were painted.
#include "core/doctor/frames/Regions.h"

#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace taa::doctor {
namespace {

using test::kPaintedPx;

RegionIndex at(const std::vector<RegionIndex>& labels, int x, int y) {
  return labels[static_cast<std::size_t>(y) * kPaintedPx.x + x];
}

// Of the painted shot: board from 70, 40 to 106, 76 at frame 0, where it has jitter (0, −1/6).
constexpr glm::ivec2 kSky{80, 8}, kGround{20, 60}, kBoard{88, 58};

} // namespace

TEST(Regions, AreObjectsByTheirIdsAndTheSky) {
  RegionTracker tracker;
  const auto labels = tracker.label(test::paintedFrame({}, 0));
  const std::set<RegionIndex> found(labels.begin(), labels.end());
  EXPECT_EQ(found.size(), 3u);
  const auto& regions = tracker.regions();
  const Region& board = regions[static_cast<std::size_t>(at(labels, kBoard.x, kBoard.y))];
  EXPECT_EQ(board.objectId, test::kBoardId);
  EXPECT_FALSE(board.isSky);
  EXPECT_EQ(board.size, 36u * 36u);
  EXPECT_EQ(board.box, glm::ivec4(70, 40, 106, 76));
  ASSERT_EQ(board.runs.size(), 36u) << "a run a row";
  EXPECT_EQ(board.runs.front(), (PixelRun{40, 70, 106}));
  EXPECT_EQ(board.runs.back(), (PixelRun{75, 70, 106}));
  EXPECT_TRUE(regions[static_cast<std::size_t>(at(labels, kSky.x, kSky.y))].isSky);
  EXPECT_EQ(regions[static_cast<std::size_t>(at(labels, kGround.x, kGround.y))].objectId, test::kGroundId);
}

TEST(Regions, AreConnectedPartsWhereThereAreNoIds) {
  RegionTracker tracker;
  DoctorFrame frame = test::paintedFrame({}, 0);
  frame.objectId.clear();
  const auto labels = tracker.label(frame);
  EXPECT_EQ(std::set<RegionIndex>(labels.begin(), labels.end()).size(), 3u);
  // The board is at half the ground's distance.
  EXPECT_NE(at(labels, kBoard.x, kBoard.y), at(labels, kGround.x, kGround.y));
  EXPECT_TRUE(tracker.regions()[static_cast<std::size_t>(at(labels, kSky.x, kSky.y))].isSky);
}

TEST(Regions, GoOnFromFrameToFrame) {
  RegionTracker tracker;
  for (int frame = 0; frame < 6; ++frame) {
    DoctorFrame painted = test::paintedFrame({}, frame);
    painted.objectId.clear();
    tracker.label(painted);
  }
  EXPECT_EQ(tracker.regions().size(), 3u);
  for (const Region& region : tracker.regions()) EXPECT_EQ(region.frames, 6);
}

TEST(Regions, AreNoneOfWhatIsTooSmall) {
  DoctorFrame frame = test::paintedFrame({}, 0);
  frame.objectId.clear();
  for (int y = 60; y < 66; ++y)
    for (int x = 20; x < 27; ++x) *frame.depthView.at(x, y) = 2.0f; // 42 pixels
  RegionTracker tracker;
  const auto labels = tracker.label(frame);
  EXPECT_EQ(at(labels, 22, 62), kNoRegion);
  EXPECT_NE(at(labels, 30, 62), kNoRegion);
}

TEST(Regions, HaveNoInsideAtTheirRims) {
  RegionTracker tracker;
  const auto labels = tracker.label(test::paintedFrame({}, 0));
  EXPECT_TRUE(isInside(labels, kPaintedPx, 88, 58));
  EXPECT_TRUE(isInside(labels, kPaintedPx, 71, 41));
  EXPECT_FALSE(isInside(labels, kPaintedPx, 70, 41));
  EXPECT_FALSE(isInside(labels, kPaintedPx, 69, 41));
  EXPECT_FALSE(isInside(labels, kPaintedPx, 0, 50));
  EXPECT_FALSE(isInside(labels, kPaintedPx, 50, kPaintedPx.y - 1));
}

TEST(Regions, KeepTheirLabelsInsideAlone) {
  RegionTracker tracker;
  const auto labels = tracker.label(test::paintedFrame({}, 0));
  const auto inside = insideOf(labels, kPaintedPx);
  EXPECT_EQ(at(inside, 71, 41), at(labels, 71, 41));
  EXPECT_EQ(at(inside, 70, 41), kNoRegion);
  EXPECT_EQ(at(inside, 0, 50), kNoRegion);
}

// Of region 1 a square of 2×2 pixels and one that hangs on it; of region 2 a row. Beyond the picture is none.
TEST(Regions, AreWideWhereASquareOfPixelsIsOfOne) {
  const std::vector<RegionIndex> labels = {1, 1, 0, 0, //
                                           1, 1, 1, 0, //
                                           2, 2, 2, 2};
  const std::string wide = "xx.."
                           "xx.."
                           "....";
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 4; ++x)
      EXPECT_EQ(isWide(labels, {4, 3}, x, y), wide[static_cast<std::size_t>(4 * y + x)] == 'x')
          << x << ' ' << y;
}

TEST(Regions, LieBetweenFourPixels) {
  const glm::ivec2 size(4, 3);
  EXPECT_EQ(pixelsAround({1.5f, 1.5f}, size), (std::array<std::size_t, 4>{5, 6, 9, 10}));
  EXPECT_EQ(pixelsAround({2.4f, 1.2f}, size), (std::array<std::size_t, 4>{1, 2, 5, 6}));
  EXPECT_FALSE(pixelsAround({0.4f, 1.5f}, size)) << "left of the first pixel's middle";
  EXPECT_FALSE(pixelsAround({3.6f, 1.5f}, size));
  EXPECT_FALSE(pixelsAround(glm::vec2(std::nanf("")), size));
}

} // namespace taa::doctor
