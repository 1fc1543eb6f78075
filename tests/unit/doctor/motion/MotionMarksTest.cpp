// Marks that are taken for motion, and motion that is taken for a mark: on evidence made by hand.
#include "core/doctor/motion/MotionMarks.h"

#include "core/doctor/examination/Doctor.h"
#include "core/render/FrameInputs.h"
#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace taa::doctor {

TEST(MotionMarks, AreLongerThanThePictureNearlyEverywhere) {
  RegionEvidence region;
  region.seen = 1000;
  region.outside = 1000;
  region.marks = 900;
  EXPECT_TRUE(isUnwrittenMark(region));
  region.marks = 899; // motion of another unit is as long, and not one value
  EXPECT_FALSE(isUnwrittenMark(region));
  region.seen = region.marks = 449; // too few
  EXPECT_FALSE(isUnwrittenMark(region));
}

TEST(MotionMarks, StandWhereWhatWasThereFits) {
  RegionEvidence region;
  region.seen = region.marked = 1000;
  region.markedTextured = 500;
  region.markedError = 500 * 0.007;
  region.markedPairs = 3;
  EXPECT_TRUE(isKeptAsMissing(region));
  region.markedError = 500 * 0.009; // something else was there
  EXPECT_FALSE(isKeptAsMissing(region));
  region.markedError = 0.0;
  region.markedPairs = 2; // first seen, and once more
  EXPECT_FALSE(isKeptAsMissing(region));
  region.markedPairs = 3;
  region.markedPx = 500 * 0.04;
  EXPECT_TRUE(isKeptAsMissing(region));
  region.markedPx = 500 * 0.06; // its motion is not 0
  EXPECT_FALSE(isKeptAsMissing(region));
  region.markedPx = 0.0;
  region.marked = 899;
  EXPECT_FALSE(isKeptAsMissing(region));
}

// A previous camera that sees nothing marks what moves as well: that is no motion of 0 which is taken for
// none.
TEST(MotionMarks, OfWhatMovesAreNotOfZero) {
  const auto toldOf = [](const glm::dvec2& cameraPx) {
    test::PaintedShot shot;
    shot.cameraPx = cameraPx;
    shot.isJittered = false; // whole pixels, so that what was there before is the same
    return examine(test::paintedExamination(shot, 12, [](DoctorFrame& frame) {
      test::changeMotion(frame, test::kGroundId,
                         [](const glm::vec2&) { return glm::vec2(kNoPreviousPosition); });
    }));
  };
  const auto names = [](const Diagnosis& diagnosis) {
    return std::ranges::count(diagnosis.findings, "zeroTakenAsMissing", &Finding::id);
  };
  const auto isOpen = [](const Diagnosis& diagnosis) {
    return std::ranges::any_of(diagnosis.parts.undecided(), [](const Undecided& open) {
      return open.question == "Motion of a part without previous position";
    });
  };
  const Diagnosis resting = toldOf({0.0, 0.0}), moving = toldOf({2.0, -1.0});
  EXPECT_EQ(names(resting), 1);
  EXPECT_FALSE(isOpen(resting));
  EXPECT_EQ(names(moving), 0);
  EXPECT_TRUE(isOpen(moving));
}

// Whether 0 is taken for none shows where the camera rests, and nowhere else.
TEST(MotionMarks, OfZeroAreLeftOpenWhereNothingRests) {
  const auto saysOpen = [](const Examination& examination) {
    const Diagnosis diagnosis = examine(examination);
    return std::ranges::any_of(diagnosis.parts.undecided(), [](const Undecided& open) {
      return open.faults == std::vector<Fault>{Fault::ZeroTakenAsMissing};
    });
  };
  Examination moving = test::paintedExamination({}, 12);
  EXPECT_TRUE(saysOpen(moving));
  test::PaintedShot rest;
  rest.cameraPx = {0.0, 0.0};
  const Examination resting = test::paintedExamination(rest, 12);
  EXPECT_FALSE(saysOpen(resting));
  moving.read = [=, read = moving.read](int frame) {
    if (frame < 5) return resting.read(frame);
    DoctorFrame out = read(frame);
    out.startsHistory = frame == 5;
    return out;
  };
  EXPECT_FALSE(saysOpen(moving)) << "it rests in some frames";
}

} // namespace taa::doctor
