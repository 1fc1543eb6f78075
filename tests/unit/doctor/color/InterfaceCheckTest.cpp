// An interface in painted frames is told with its place, drawn with the jitter or without, and all behind it
// is examined as if it were not there.
#include "core/doctor/color/InterfaceCheck.h"

#include "tests/support/doctor/PaintedFrames.h"
#include "tests/support/doctor/PaintedInterface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace taa::doctor {
namespace {

constexpr int kFrames = 8;

Diagnosis diagnosisOf(const test::FrameFault& fault, const test::PaintedShot& shot = {}) {
  return examine(test::paintedExamination(shot, kFrames, fault));
}

std::string told(const Diagnosis& diagnosis) {
  std::string text;
  for (const Finding& finding : diagnosis.findings) text += (text.empty() ? "" : ", ") + finding.id;
  return text;
}

bool isOpen(const Diagnosis& diagnosis, Fault fault) {
  return std::ranges::any_of(diagnosis.parts.undecided(), [&](const Undecided& open) {
    return std::ranges::find(open.faults, fault) != open.faults.end();
  });
}

void paintStill(DoctorFrame& frame) {
  test::paintInterface(frame, glm::vec2(0.0f));
}
void paintJittered(DoctorFrame& frame) {
  test::paintInterface(frame, frame.jitterPx);
}

test::PaintedShot stillShot() {
  test::PaintedShot out;
  out.cameraPx = out.boardPx = {0.0, 0.0};
  return out;
}

} // namespace

TEST(InterfaceCheck, TellsOneThatRestsOnTheScreenAndNothingElse) {
  const Diagnosis diagnosis = diagnosisOf(paintStill);
  ASSERT_EQ(told(diagnosis), "interfaceBefore");
  const Finding& finding = diagnosis.findings[0];
  ASSERT_EQ(finding.regions.size(), 1u);
  EXPECT_EQ(finding.regions[0].box, glm::ivec4(0, test::kBarTop, test::kPaintedPx.x, test::kBarBottom));
  EXPECT_EQ(finding.regions[0].name, "160 × 24 pixels at 0, 56");
  EXPECT_DOUBLE_EQ(finding.regions[0].share, 0.25); // 24 of 96 rows
  ASSERT_EQ(finding.regions[0].pixels.size(), 24u);
  EXPECT_EQ(finding.regions[0].pixels[0], (PixelRun{test::kBarTop, 0, test::kPaintedPx.x}));
  ASSERT_EQ(finding.residuals.size(), 4u);
  EXPECT_EQ(finding.residuals[0].id, "inPlace");
  EXPECT_EQ(finding.residuals[0].value, 0.0);
  EXPECT_TRUE(finding.residuals[0].isBest);
}

TEST(InterfaceCheck, TellsOneThatIsJittered) {
  const Diagnosis diagnosis = diagnosisOf(paintJittered);
  ASSERT_EQ(told(diagnosis), "interfaceJittered");
  EXPECT_EQ(diagnosis.findings[0].residuals[0].id, "jittered");
}

// Balls that a camera goes around look the same from all sides: their silhouettes rest on the screen and
// follow the jitter, and the motion of their surfaces is right.
TEST(InterfaceCheck, LeavesOpenWhatRestsAtRimsOfObjects) {
  const Diagnosis diagnosis = diagnosisOf([](DoctorFrame& frame) {
    paintJittered(frame);
    for (int y = test::kBarTop; y < test::kBarBottom; ++y)
      for (int x = 0; x < frame.sizePx().x; ++x)
        frame.objectId[static_cast<std::size_t>(y) * frame.sizePx().x + x] =
            static_cast<std::uint32_t>(100 + x / 4 + 40 * (y / 4));
  });
  EXPECT_EQ(told(diagnosis), "");
  EXPECT_TRUE(isOpen(diagnosis, Fault::InterfaceJittered));
}

TEST(InterfaceCheck, IsToldBesideWrongJitter) {
  const Diagnosis diagnosis = diagnosisOf([](DoctorFrame& frame) {
    paintStill(frame);
    frame.jitterPx = -frame.jitterPx;
  });
  EXPECT_EQ(told(diagnosis), "interfaceBefore, jitterNegated");
}

// One that is drawn with the jitter rests by that jitter alone, and shows once it is known.
TEST(InterfaceCheck, TellsOneThatIsJitteredOnceJitterIsRight) {
  EXPECT_EQ(told(diagnosisOf([](DoctorFrame& frame) {
              paintJittered(frame);
              frame.jitterPx = -frame.jitterPx;
            })),
            "jitterNegated, interfaceJittered");
}

TEST(InterfaceCheck, LeavesOneOpenWhereMotionHasItRestLikeAllElse) {
  const Diagnosis diagnosis = diagnosisOf([](DoctorFrame& frame) {
    paintJittered(frame);
    for (float& px : frame.motionPx.pixels) px *= 0.004f;
  });
  EXPECT_TRUE(isOpen(diagnosis, Fault::InterfaceJittered)) << told(diagnosis);
}

// What moves by the motion given alone does not move.
TEST(InterfaceCheck, LeavesOneOpenBeforeARestingWorldWhoseMotionIsWrong) {
  const auto diagnosisAt = [](float px) {
    return diagnosisOf(
        [px](DoctorFrame& frame) {
          paintJittered(frame);
          for (std::size_t i = 0; i < frame.motionPx.pixels.size(); i += 2) frame.motionPx.pixels[i] += px;
        },
        stillShot());
  };
  EXPECT_TRUE(isOpen(diagnosisAt(0.0f), Fault::InterfaceJittered));
  EXPECT_TRUE(isOpen(diagnosisAt(4.0f), Fault::InterfaceJittered)) << told(diagnosisAt(4.0f));
}

// At rest, what does not shift with the jitter of all else rests on the screen; what does is of the world.
TEST(InterfaceCheck, OfAStillPictureTellsOnlyTheOneWithoutJitter) {
  EXPECT_EQ(told(diagnosisOf(paintStill, stillShot())), "interfaceBefore");
  const Diagnosis jittered = diagnosisOf(paintJittered, stillShot());
  EXPECT_EQ(told(jittered), "");
  EXPECT_TRUE(isOpen(jittered, Fault::InterfaceJittered));
  EXPECT_FALSE(isOpen(jittered, Fault::InterfaceBefore));
}

TEST(InterfaceCheck, TellsNoneWhereAllRests) {
  test::PaintedShot shot = stillShot();
  shot.isJittered = false;
  const Diagnosis diagnosis = diagnosisOf(paintStill, shot);
  EXPECT_EQ(told(diagnosis), "");
  EXPECT_TRUE(isOpen(diagnosis, Fault::InterfaceBefore));
}

// Jitter that is stated and not drawn: the still picture rests, and none of it is an interface.
TEST(InterfaceCheck, TellsNoneWherePicturesHoldNoJitter) {
  test::PaintedShot shot = stillShot();
  shot.isJittered = false;
  EXPECT_EQ(
      told(diagnosisOf(
          [](DoctorFrame& frame) { frame.jitterPx = test::paintedFrame({}, frame.frame).jitterPx; }, shot)),
      "jitterNotApplied");
}

TEST(InterfaceCheck, TellsNoneWhereMotionIsWrong) {
  const Diagnosis diagnosis = diagnosisOf([](DoctorFrame& frame) {
    for (float& px : frame.motionPx.pixels) px = -px;
  });
  EXPECT_EQ(told(diagnosis).find("interface"), std::string::npos) << told(diagnosis);
}

// By motion that is far too long edges seem to rest; the motion of what rests in the world fits them better.
TEST(InterfaceCheck, TellsNoneThatMovesAsTheWorldDoes) {
  const auto groupsWhereTheWorldLeaves = [](double ofWorld) {
    ScreenTile tile;
    tile.pairs = tile.jittered = tile.jitteredOfAll = 8;
    tile.sums.pixels = 200;
    tile.sums.inPlace = 5.0;
    tile.sums.jittered = 3.0;
    tile.sums.asGiven = 7.0;
    tile.sums.ofWorld = ofWorld;
    ScreenTiles tiles;
    tiles.sizePx = {40, 40};
    tiles.counts = {5, 5};
    tiles.tiles.assign(25, tile);
    tiles.labels.assign(1600, kNoRegion);
    return interfaceGroups(tiles);
  };
  EXPECT_EQ(groupsWhereTheWorldLeaves(6.0).clear.size(), 1u);
  // Still less than what rests in these squares one by one, and not in all of them together.
  EXPECT_TRUE(groupsWhereTheWorldLeaves(2.5).clear.empty());
}

TEST(InterfaceCheck, CoversASquareAroundIt) {
  ScreenTiles tiles;
  tiles.sizePx = {40, 40};
  tiles.counts = {5, 5};
  tiles.tiles.resize(25);
  const std::vector<std::uint8_t> covered = coveredPixels({{false, {12}, {}}}, tiles); // the middle one
  ASSERT_EQ(covered.size(), 1600u);
  EXPECT_EQ(std::ranges::count(covered, 1), 24 * 24);
  EXPECT_EQ(covered[8 * 40 + 8], 1);
  EXPECT_EQ(covered[8 * 40 + 7], 0);
  EXPECT_TRUE(coveredPixels({}, tiles).empty());
}

} // namespace taa::doctor
