// What depth and matrices say of motion, on hand-made distances and on painted frames.
#include "core/doctor/motion/MotionConsistency.h"

#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace taa::doctor {
namespace {

/// Of the ground of a painted shot, all of whose motion is multiplied.
ConsistencyDecision groundTimes(const glm::vec2& factor) {
  const test::PaintedShot shot;
  const std::vector<MotionTrial> trials = motionTrials(test::kPaintedPx);
  DoctorFrame now = test::paintedFrame(shot, 2), before = test::paintedFrame(shot, 1);
  for (DoctorFrame* frame : {&now, &before})
    test::changeMotion(*frame, test::kGroundId, [&](const glm::vec2& m) { return factor * m; });
  const FrameNeighbors frames{now, before, nullptr};
  ConsistencyEvidence evidence;
  for (int y = 60; y < 80; ++y)
    for (int x = 4; x < 60; ++x) addConsistency(evidence, trials, frames, {x, y});
  return decideConsistency(evidence, trials);
}

std::vector<MotionTrial> explained(const ConsistencyDecision& decision) {
  std::vector<MotionTrial> out;
  for (const std::size_t trial : decision.explanations) out.push_back(motionTrials(test::kPaintedPx)[trial]);
  return out;
}

} // namespace

TEST(MotionConsistency, CountsDistancesByHalvesOfAnOctave) {
  DistanceCounts counts;
  for (const float distance : {0.01f, 0.25f, 4.0f}) counts.add(distance);
  EXPECT_EQ(counts.medianPx(), 0.25);
  EXPECT_EQ(counts.upTo(0.25), 2u);
  EXPECT_EQ(counts.upTo(4.0), 3u);
}

TEST(MotionConsistency, FindsTheCamerasOwnMotion) {
  EXPECT_EQ(groundTimes({1.0f, 1.0f}).verdict, ConsistencyVerdict::OfCamera);
}

TEST(MotionConsistency, FindsWhatMakesTheCamerasMotionOfTheMotionGiven) {
  const ConsistencyDecision negated = groundTimes({1.0f, -1.0f});
  ASSERT_EQ(negated.verdict, ConsistencyVerdict::Explained);
  ASSERT_EQ(explained(negated).size(), 1u);
  EXPECT_EQ(explained(negated)[0].kind, MotionKind::MirroredY);
  const ConsistencyDecision device = groundTimes({2.0f / 160.0f, -2.0f / 96.0f});
  ASSERT_EQ(explained(device).size(), 1u);
  EXPECT_TRUE(explained(device)[0].isDevice);
}

TEST(MotionConsistency, SaysNothingOfWhatMovesByItself) {
  EXPECT_EQ(groundTimes({1.37f, 0.61f}).verdict, ConsistencyVerdict::Apart);
}

TEST(MotionConsistency, FindsTheOnlyFrameOfAMatrixThatWasNeverSet) {
  std::vector<PairConsistency> pairs(5, PairConsistency{0, 1000, 10, 0});
  for (int i = 0; i < 5; ++i) pairs[static_cast<std::size_t>(i)].frame = i + 1;
  EXPECT_FALSE(identityFrame(pairs));
  pairs[2] = {3, 1000, 990, 980};
  EXPECT_EQ(identityFrame(pairs), 3);
  pairs[2].ofIdentity = 100;
  EXPECT_FALSE(identityFrame(pairs));
}

TEST(MotionConsistency, IsLateWhereRimsHaveTheMotionOfAFrameAgo) {
  ConsistencyEvidence silhouettes;
  silhouettes.off = 100;
  silhouettes.offLate = 80;
  silhouettes.lateFrames = {3, 4};
  EXPECT_FALSE(isLateAtSilhouettes(silhouettes)) << "in a frame or two things stop";
  silhouettes.lateFrames.insert(7);
  EXPECT_TRUE(isLateAtSilhouettes(silhouettes));
  silhouettes.offLate = 79;
  EXPECT_FALSE(isLateAtSilhouettes(silhouettes));
}

// A camera that turns about its axis and moves sideways makes another motion of matrices that are upside
// down, and nothing that could be wrong with motion makes that of it.
TEST(MotionConsistency, FindsMatricesThatAreUpsideDown) {
  const std::vector<MotionTrial> trials = motionTrials(test::kPaintedPx);
  const auto isFlipped = [&](bool isTurnedOver) {
    DoctorFrame now = test::paintedFrame({}, 2), before = test::paintedFrame({}, 1);
    glm::mat4 turn(1.0f);
    turn[0][1] = 0.08f, turn[1][0] = -0.05f, turn[3][0] = 0.07f;
    now.previousClipFromClip = turn;
    for (int y = 0; y < now.motionPx.height; ++y)
      for (int x = 0; x < now.motionPx.width; ++x) {
        const auto moved = cameraMotionPx(now, {x, y});
        now.motionPx.at(x, y)[0] = moved->x;
        now.motionPx.at(x, y)[1] = moved->y;
      }
    if (isTurnedOver) now.previousClipFromClip = flippedMatrix(turn);
    ConsistencyEvidence evidence;
    for (int y = 4; y < 92; ++y)
      for (int x = 4; x < 156; ++x) addConsistency(evidence, trials, {now, before, nullptr}, {x, y});
    return areMatricesFlipped({&evidence}, trials);
  };
  EXPECT_TRUE(isFlipped(true));
  EXPECT_FALSE(isFlipped(false));
}

} // namespace taa::doctor
