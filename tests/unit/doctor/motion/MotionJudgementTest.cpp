// What regions are told by where depth and matrices are witnesses: on painted frames.
#include "core/doctor/motion/MotionJudgement.h"

#include "core/doctor/frames/Regions.h"
#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
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
    EXPECT_TRUE(region.isWitnessed);
    ASSERT_TRUE(region.trial);
    EXPECT_EQ(trialId(painted.evidence.trials()[*region.trial]), "scaled:2");
  }
  EXPECT_FALSE(judged.contradicted);
}

TEST(MotionJudgement, LeavesToPixelsWhatMovesByItself) {
  const PaintedCase painted({1.0f, -1.0f}, false);
  const Judged judged = judgeMotion(painted.evidence, painted.tracker.regions());
  for (const JudgedRegion& region : judged.regions) {
    EXPECT_FALSE(region.isWitnessed);
    EXPECT_EQ(region.trial.has_value(), region.region->objectId == test::kBoardId);
  }
}

} // namespace taa::doctor
