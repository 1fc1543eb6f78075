// Squares of the picture say what their edges do, in frames whose motion is known.
#include "core/doctor/color/ScreenTiles.h"

#include "tests/support/doctor/PaintedFrames.h"
#include "tests/support/doctor/PaintedInterface.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace taa::doctor {
namespace {

constexpr int kFrames = 6;

ScreenTiles tilesOf(const test::FrameFault& fault) {
  ScreenTiles out;
  for (int frame = 1; frame < kFrames; ++frame) {
    DoctorFrame now = test::paintedFrame({}, frame), before = test::paintedFrame({}, frame - 1);
    fault(now);
    fault(before);
    RegionTracker tracker;
    const std::vector<RegionIndex> labels = tracker.label(now);
    out.add({now, before}, labels);
  }
  return out;
}

/// The one with a pixel in it.
const ScreenTile& tileAt(const ScreenTiles& tiles, int x, int y) {
  return tiles.tiles[static_cast<std::size_t>(y / kTilePx) * tiles.counts.x + x / kTilePx];
}

} // namespace

TEST(ScreenTiles, AreOfTheWholePicture) {
  const ScreenTiles tiles = tilesOf([](DoctorFrame&) {});
  EXPECT_EQ(tiles.counts, glm::ivec2(20, 12)); // of 160 × 96 pixels
  EXPECT_EQ(tiles.tiles.size(), 240u);
  EXPECT_EQ(tiles.frame, kFrames - 1);
  EXPECT_EQ(tiles.pairs, kFrames - 1);
  EXPECT_EQ(tiles.jitteredPairs, kFrames - 1);
}

TEST(ScreenTiles, OfTheGroundMoveAsTheyAreSaidTo) {
  const ScreenTiles tiles = tilesOf([](DoctorFrame&) {});
  const ScreenTile& ground = tileAt(tiles, 20, 60);
  ASSERT_EQ(ground.pairs, kFrames - 1);
  EXPECT_EQ(ground.fixed, 0);
  EXPECT_EQ(ground.changing, ground.pairs);
  EXPECT_EQ(ground.jittered, 0);
  EXPECT_LT(ground.sums.asGiven, 0.2 * ground.sums.inPlace);
  EXPECT_NEAR(ground.sums.asGiven, ground.sums.ofWorld, 1e-4); // it is the camera's, made of floats
  EXPECT_NEAR(ground.meanWorldPx(), 2.704, 0.001);             // |(2.25, −1.5)|
}

TEST(ScreenTiles, OfAnInterfaceRestOnTheScreen) {
  const ScreenTiles tiles = tilesOf([](DoctorFrame& frame) { test::paintInterface(frame, glm::vec2(0.0f)); });
  const ScreenTile& bar = tileAt(tiles, 20, 68);
  ASSERT_EQ(bar.pairs, kFrames - 1);
  EXPECT_EQ(bar.fixed, bar.pairs);
  EXPECT_EQ(bar.sums.inPlace, 0.0);
  EXPECT_GT(bar.sums.moving(), 0.0);
}

TEST(ScreenTiles, OfAJitteredInterfaceRestButForJitter) {
  const ScreenTiles tiles = tilesOf([](DoctorFrame& frame) { test::paintInterface(frame, frame.jitterPx); });
  const ScreenTile& bar = tileAt(tiles, 20, 68);
  EXPECT_EQ(bar.fixed, 0);
  EXPECT_EQ(bar.jitteredOfAll, bar.pairs);
  EXPECT_LT(bar.sums.jittered, 0.67 * bar.sums.inPlace);
}

TEST(ScreenTiles, WithoutEdgesCountNoPairs) {
  EXPECT_EQ(tileAt(tilesOf([](DoctorFrame&) {}), 20, 4).pairs, 0); // the plain sky
}

} // namespace taa::doctor
