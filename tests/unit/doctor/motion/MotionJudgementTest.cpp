// What regions are told by where depth and matrices are evidence: on painted frames.
#include "core/doctor/motion/MotionJudgement.h"

#include "core/doctor/frames/Regions.h"
#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace taa::doctor {
namespace {

struct PaintedCase {
  RegionTracker tracker;
  MotionEvidence evidence{test::kPaintedPx};

  /// Of six frames, in which the motion of one object, or of all, is multiplied.
  PaintedCase(const glm::vec2& factor, bool isAll) {
    std::vector<DoctorFrame> frames;
    for (int i = 0; i < 6; ++i) {
      frames.push_back(test::paintedFrame({}, i));
      for (const std::uint32_t id : {0u, test::kGroundId, test::kBoardId})
        if (isAll || id == test::kBoardId)
          test::changeMotion(frames.back(), id, [&](const glm::vec2& m) { return factor * m; });
    }
    std::vector<RegionIndex> before = tracker.label(frames[0]);
    for (std::size_t i = 1; i < frames.size(); ++i) {
      const std::vector<RegionIndex> labels = tracker.label(frames[i]);
      evidence.add({frames[i], frames[i - 1], i + 1 < frames.size() ? &frames[i + 1] : nullptr}, labels,
                   before);
      before = labels;
    }
  }
};

} // namespace

TEST(MotionJudgement, TellsWhatRestsByDepthAndMatricesThoughItIsPlain) {
  const PaintedCase painted({0.5f, 0.5f}, true);
  const Judged judged = judgeMotion(painted.evidence, painted.tracker.regions());
  ASSERT_FALSE(judged.regions.empty());
  for (const JudgedRegion& region : judged.regions) {
    if (region.region->objectId == test::kBoardId) continue;
    EXPECT_TRUE(region.isChecked);
    ASSERT_TRUE(region.trial);
    EXPECT_EQ(trialId(painted.evidence.trials()[*region.trial]), "scaled:2");
  }
  EXPECT_FALSE(judged.contradicted);
}

TEST(MotionJudgement, LeavesToPixelsWhatMovesByItself) {
  const PaintedCase painted({1.0f, -1.0f}, false);
  const Judged judged = judgeMotion(painted.evidence, painted.tracker.regions());
  for (const JudgedRegion& region : judged.regions) {
    EXPECT_FALSE(region.isChecked);
    EXPECT_EQ(region.trial.has_value(), region.region->objectId == test::kBoardId);
  }
}

// Jitter is left in the motion of one thing alone, and that of the ground is right: told where it shows in
// many squares, as of what an own pass draws, and not where it shows in few, as a thin thing stays on its
// pixels.
TEST(MotionJudgement, TellsJitterOfOneThingAloneOnlyInManySquares) {
  const auto trialOfBoard = [](int count) -> std::string {
    std::vector<DoctorFrame> frames;
    for (int i = 0; i < count; ++i) {
      DoctorFrame& frame = frames.emplace_back(test::paintedFrame({}, i));
      frame.previousClipFromClip.reset();
      const glm::vec2 step = i == 0 ? glm::vec2(0.0f) : frame.jitterPx - frames[frames.size() - 2].jitterPx;
      test::changeMotion(frame, test::kBoardId, [&](const glm::vec2& motion) { return motion + step; });
    }
    RegionTracker tracker;
    MotionEvidence evidence(test::kPaintedPx);
    std::vector<RegionIndex> before = tracker.label(frames[0]);
    for (std::size_t i = 1; i < frames.size(); ++i) {
      const std::vector<RegionIndex> labels = tracker.label(frames[i]);
      evidence.add({frames[i], frames[i - 1]}, labels, before);
      before = labels;
    }
    for (const JudgedRegion& region : judgeMotion(evidence, tracker.regions()).regions) {
      if (region.region->objectId != test::kBoardId) continue;
      EXPECT_EQ(decideMotion(*region.evidence, evidence.trials()).verdict, MotionVerdict::Wrong);
      if (region.trial) return trialId(evidence.trials()[*region.trial]);
    }
    return "";
  };
  EXPECT_EQ(trialOfBoard(5), "");
  EXPECT_EQ(trialOfBoard(20), "jitterOfBoth");
}

// Of the sky alone a frame late is told by nobody: what moves before it leaks into it where motion is a mean.
TEST(MotionJudgement, LeavesASkyOpenThatAloneIsAFrameLate) {
  test::PaintedShot shot;
  shot.change = 0.8;
  std::vector<DoctorFrame> frames;
  for (int i = 0; i < 8; ++i) {
    DoctorFrame& frame = frames.emplace_back(test::paintedFrame(shot, i));
    frame.previousClipFromClip.reset();
    // A sky with the ground's detail, whose motion is that of the frame before.
    const glm::vec2 late = test::paintedFrame(shot, std::max(0, i - 1)).motionAt(0, 95);
    for (std::size_t p = 0; p < frame.objectId.size(); ++p) {
      if (frame.objectId[p] == test::kBoardId) continue;
      frame.objectId[p] = 0;
      frame.depth.pixels[p] = frame.depthView.pixels[p] = frame.previousDepthView.pixels[p] = 0.0f;
    }
    test::changeMotion(frame, 0, [late](const glm::vec2&) { return late; });
  }
  RegionTracker tracker;
  MotionEvidence evidence(test::kPaintedPx);
  std::vector<RegionIndex> before = tracker.label(frames[0]);
  for (std::size_t i = 1; i + 1 < frames.size(); ++i) {
    const std::vector<RegionIndex> labels = tracker.label(frames[i]);
    evidence.add({frames[i], frames[i - 1], &frames[i + 1]}, labels, before);
    before = labels;
  }
  const auto sky = std::ranges::find(tracker.regions(), true, &Region::isSky);
  ASSERT_NE(sky, tracker.regions().end());
  const RegionEvidence& ofSky = evidence.regions()[static_cast<std::size_t>(sky - tracker.regions().begin())];
  const MotionDecision byItself = decideMotion(ofSky, evidence.trials());
  ASSERT_EQ(byItself.verdict, MotionVerdict::Wrong);
  ASSERT_EQ(trialId(evidence.trials()[byItself.explanations.at(0)]), "frameLate");
  for (const JudgedRegion& region : judgeMotion(evidence, tracker.regions()).regions) {
    if (!region.region->isSky) continue;
    EXPECT_FALSE(region.trial);
    EXPECT_EQ(region.decision.verdict, MotionVerdict::Contradicted);
  }
}

} // namespace taa::doctor
