// Outlines of a plain board that moves, in painted frames whose every motion is known.
#include "core/doctor/motion/MotionOutlines.h"

#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace taa::doctor {
namespace {

using Change = std::function<glm::vec2(const glm::vec2&)>;

/// Of the board, whose motion is changed, over 6 frames before a camera that rests.
OutlineEvidence boardOutline(const glm::dvec2& boardPx, const Change& change, bool isJittered = true) {
  test::PaintedShot shot;
  shot.cameraPx = {0.0, 0.0};
  shot.boardPx = boardPx;
  shot.isBoardTextured = false;
  shot.isJittered = isJittered;
  const std::vector<MotionTrial> trials = motionTrials(test::kPaintedPx);
  RegionTracker tracker;
  OutlineEvidence out;
  DoctorFrame before;
  std::vector<RegionIndex> labelsBefore;
  for (int frame = 0; frame < 6; ++frame) {
    DoctorFrame now = test::paintedFrame(shot, frame);
    test::changeMotion(now, test::kBoardId, change);
    const std::vector<RegionIndex> labels = tracker.label(now);
    if (frame > 0)
      for (const auto& [region, outline] : outlinesOf({now, before, nullptr}, trials, labels, labelsBefore))
        if (tracker.regions()[static_cast<std::size_t>(region)].objectId == test::kBoardId) out.add(outline);
    before = now;
    labelsBefore = labels;
  }
  return out;
}

/// Ids of what wins, by commas.
std::string winnersOf(const OutlineEvidence& evidence) {
  const std::vector<MotionTrial> trials = motionTrials(test::kPaintedPx);
  std::string text;
  for (const std::size_t t : outlineWinners(evidence)) text += (text.empty() ? "" : ",") + trialId(trials[t]);
  return text;
}

glm::vec2 same(const glm::vec2& motion) {
  return motion;
}

} // namespace

TEST(MotionOutlines, FitWhereMotionIsRight) {
  const OutlineEvidence right = boardOutline({4.0, 2.0}, same);
  EXPECT_EQ(winnersOf(right), "");
  EXPECT_FALSE(isOutlineFoundElsewhere(right));
  std::size_t given = 0, tried = 0;
  for (const OutlineCounts& trial : right.trials) {
    given += trial.given;
    tried += trial.tried;
  }
  EXPECT_EQ(given, 0u) << "what lies inside the board lay inside it";
  EXPECT_GT(tried, 1000u) << "other explanations lead out of it";
}

TEST(MotionOutlines, NameWhatMotionIsInstead) {
  EXPECT_EQ(winnersOf(boardOutline({4.0, 3.0}, [](const glm::vec2& m) { return glm::vec2(m.x, -m.y); })),
            "mirroredY");
  EXPECT_EQ(winnersOf(boardOutline({4.0, -3.0}, [](const glm::vec2& m) { return -m; })), "opposite");
  EXPECT_EQ(winnersOf(boardOutline({4.0, -1.0}, [](const glm::vec2& m) { return glm::vec2(m.y, m.x); })),
            "swappedAxes");
}

// With motion 0 the strip that the board has newly covered came from outside of it. Without jitter it is 4 px
// wide and 36 high.
TEST(MotionOutlines, CountWhatCameFromOutside) {
  const OutlineEvidence still = boardOutline(
      {4.0, 0.0}, [](const glm::vec2&) { return glm::vec2(0.0f); }, false);
  EXPECT_EQ(still.found.given, 5u * 4 * 36);
  EXPECT_EQ(still.found.tried, 0u);
  EXPECT_EQ(still.found.pairs, 5u);
  EXPECT_EQ(still.found.pairsWon, 5u);
  EXPECT_TRUE(isOutlineFoundElsewhere(still));
  EXPECT_EQ(winnersOf(still), "") << "no explanation makes a motion of 0";
}

// Depth that has not the jitter that is stated moves outlines by up to a pixel from frame to frame: what
// leads no farther from the motion given is not asked.
TEST(MotionOutlines, SayNothingOfLessThanJitterMayBe) {
  const Change opposite = [](const glm::vec2& m) { return -m; };
  EXPECT_EQ(winnersOf(boardOutline({1.5, 1.5}, opposite)), "opposite");
  const OutlineEvidence slow = boardOutline({0.5, 0.5}, opposite);
  EXPECT_EQ(winnersOf(slow), "");
  EXPECT_FALSE(isOutlineFoundElsewhere(slow));
}

TEST(MotionOutlines, AreThoseOfObjectsWithANumber) {
  const DoctorFrame before = test::paintedFrame({}, 0);
  DoctorFrame now = test::paintedFrame({}, 1);
  RegionTracker tracker;
  const std::vector<RegionIndex> labelsBefore = tracker.label(before), labels = tracker.label(now);
  const std::vector<MotionTrial> trials = motionTrials(test::kPaintedPx);
  EXPECT_EQ(outlinesOf({now, before, nullptr}, trials, labels, labelsBefore).size(), 2u)
      << "ground and board";
  now.objectId.clear();
  EXPECT_TRUE(outlinesOf({now, before, nullptr}, trials, labels, labelsBefore).empty());
}

TEST(MotionOutlines, KeepWhatTheyFitFromBeingMendedWithAll) {
  const OutlineEvidence right = boardOutline({4.0, 2.0}, same);
  const std::vector<MotionTrial> trials = motionTrials(test::kPaintedPx);
  for (std::size_t t = 0; t < trials.size(); ++t) {
    const bool isOut = trials[t].kind == MotionKind::Opposite;
    if (isOut || trials[t].kind == MotionKind::JitterOfThis) {
      EXPECT_EQ(breaksOutline(t, right), isOut) << trialId(trials[t]);
    }
  }
}

} // namespace taa::doctor
