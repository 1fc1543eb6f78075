// Marks that are taken for motion, and motion that is taken for a mark: on evidence made by hand.
#include "core/doctor/motion/MotionMarks.h"

#include "core/doctor/Doctor.h"
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
  region.marked = 899;
  EXPECT_FALSE(isKeptAsMissing(region));
}

// Whether 0 is taken for none shows where the camera rests, and nowhere else.
TEST(MotionMarks, OfZeroAreLeftOpenWhereNothingRests) {
  const auto saysOpen = [](const test::PaintedShot& shot) {
    const Diagnosis diagnosis = examine(test::paintedExamination(shot, 12));
    return std::ranges::any_of(diagnosis.undecided, [](const Undecided& open) {
      return open.faults == std::vector<Fault>{Fault::ZeroTakenAsMissing};
    });
  };
  EXPECT_TRUE(saysOpen({}));
  test::PaintedShot resting;
  resting.cameraPx = {0.0, 0.0};
  EXPECT_FALSE(saysOpen(resting));
}

} // namespace taa::doctor
