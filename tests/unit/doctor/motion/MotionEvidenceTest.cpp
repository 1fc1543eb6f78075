// What is gathered of a region's pixels, in painted frames whose every motion is known.
#include "core/doctor/motion/MotionEvidence.h"

#include "core/render/FrameInputs.h"
#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace taa::doctor {
namespace {

/// Of the region of an object, or of the sky, in all pairs of some frames.
RegionEvidence evidenceOf(std::uint32_t objectId, const test::FrameFault& fault) {
  RegionTracker tracker;
  MotionEvidence evidence(test::kPaintedPx);
  const doctor::Examination examination = test::paintedExamination({}, 5, fault);
  std::vector<RegionIndex> labelsBefore;
  DoctorFrame before = examination.read(0);
  labelsBefore = tracker.label(before);
  for (int frame = 1; frame < 5; ++frame) {
    DoctorFrame now = examination.read(frame);
    const std::vector<RegionIndex> labels = tracker.label(now);
    evidence.add({now, before, nullptr}, labels, labelsBefore);
    before = now;
    labelsBefore = labels;
  }
  const auto& regions = tracker.regions();
  const auto found = std::ranges::find(regions, objectId, &Region::objectId);
  return evidence.regions()[static_cast<std::size_t>(found - regions.begin())];
}

} // namespace

TEST(EvenVectors, SpreadByTheirDistanceFromTheirMean) {
  EvenVectors vectors;
  EXPECT_TRUE(std::isinf(vectors.spread()));
  vectors.add({4.0, 0.0});
  vectors.add({2.0, 0.0});
  // One px to each side of a mean of 3 px.
  EXPECT_NEAR(vectors.spread(), 1.0 / 3.0, 1e-12);
}

TEST(MotionEvidence, KnowsTheCamerasMotionByDepthAndMatrices) {
  const RegionEvidence ground = evidenceOf(test::kGroundId, {});
  EXPECT_GT(ground.pixels, 1000u);
  EXPECT_EQ(ground.cameraKnown, ground.pixels);
  EXPECT_EQ(ground.ofCamera, ground.pixels);
  EXPECT_EQ(ground.pairs, 4u);
  EXPECT_EQ(ground.marked, 0u);
  EXPECT_EQ(ground.outside, 0u);
  const RegionEvidence board = evidenceOf(test::kBoardId, {});
  EXPECT_EQ(board.ofCamera, 0u);
  // It moves by (1.5, 3) px besides the camera, everywhere.
  EXPECT_NEAR(board.offCamera.sum.x, 1.5 * static_cast<double>(board.offCamera.count),
              0.01 * static_cast<double>(board.pixels));
  EXPECT_LT(board.offCamera.spread(), 1e-3);
}

TEST(MotionEvidence, CountsMarksAndMotionLongerThanThePicture) {
  const auto written = [](const glm::vec2& value) {
    return evidenceOf(test::kBoardId, [value](DoctorFrame& frame) {
      test::changeMotion(frame, test::kBoardId, [value](const glm::vec2&) { return value; });
    });
  };
  const RegionEvidence marked = written(glm::vec2(kNoPreviousPosition));
  EXPECT_GT(marked.seen, 500u);
  EXPECT_EQ(marked.marked, marked.seen);
  EXPECT_EQ(marked.markedPairs, 4u);
  EXPECT_EQ(marked.pixels, 0u);
  const RegionEvidence unwritten = written(-glm::vec2(test::kPaintedPx));
  EXPECT_EQ(unwritten.outside, unwritten.seen);
}

TEST(MotionEvidence, TakesTheRimAlongWithWhatMoves) {
  const RegionEvidence board = evidenceOf(test::kBoardId, [](DoctorFrame& frame) {
    test::changeMotion(frame, test::kBoardId, [](const glm::vec2&) { return glm::vec2(0.0f); });
  });
  EXPECT_GT(board.found.pixels, 0u);
  EXPECT_GT(board.silhouetteGiven, 50u);
  EXPECT_LT(2 * board.silhouetteFound, board.silhouetteGiven);
}

} // namespace taa::doctor
