// Motion that is wrong in some frames, or in a part of a region, on evidence made by hand and in painted
// frames.
#include "core/doctor/motion/MotionPairs.h"

#include "core/doctor/examination/Doctor.h"
#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace taa::doctor {
namespace {

const std::vector<MotionTrial> kTrials = motionTrials({320, 180});

std::size_t trialOf(MotionKind kind) {
  const auto found = std::ranges::find(kTrials, kind, &MotionTrial::kind);
  return static_cast<std::size_t>(found - kTrials.begin());
}

/// A thousand pixels in each of eight pairs; in `won` a trial leads elsewhere at `pixels` of them, and leaves
/// 0.01 of luma at each where the motion given leaves `given`.
RegionEvidence evidenceOf(MotionKind kind, const std::vector<int>& won, std::size_t pixels, double given) {
  RegionEvidence out;
  for (int frame = 1; frame <= 8; ++frame) {
    PairTrace pair{frame, 1000, 0.0, 0, 0.0, 0.0, std::vector<TrialOfPair>(kTrials.size())};
    const auto count = static_cast<double>(pixels);
    if (std::ranges::count(won, frame) > 0)
      pair.trials[trialOf(kind)] = {pixels, given * count, 0.01 * count, {frame, 7}, 0.1f};
    out.traces.push_back(std::move(pair));
  }
  return out;
}

std::optional<WonPairs> wonOf(MotionKind kind, const std::vector<int>& won, std::size_t pixels,
                              double given) {
  return wonPairs(evidenceOf(kind, won, pixels, given), kTrials);
}

/// With what `fault` makes of the motion of pixels of one of its things.
using FaultAt = std::function<glm::vec2(const glm::vec2& motion, const glm::ivec2& pixel, int frame)>;
Diagnosis diagnosisOf(std::uint32_t objectId, const FaultAt& fault) {
  return examine(test::paintedExamination({}, 12, [&](DoctorFrame& frame) {
    for (int y = 0; y < test::kPaintedPx.y; ++y)
      for (int x = 0; x < test::kPaintedPx.x; ++x) {
        const std::size_t i = static_cast<std::size_t>(y) * test::kPaintedPx.x + x;
        if (frame.objectId[i] != objectId) continue;
        float* motion = frame.motionPx.pixels.data() + 2 * i;
        const glm::vec2 changed = fault({motion[0], motion[1]}, {x, y}, frame.frame);
        motion[0] = changed.x;
        motion[1] = changed.y;
      }
  }));
}

} // namespace

TEST(MotionPairs, AreWonClearlyByEnoughPixels) {
  const auto won = wonOf(MotionKind::FrameEarly, {3, 6}, 200, 0.03);
  ASSERT_TRUE(won);
  EXPECT_EQ(won->trial, trialOf(MotionKind::FrameEarly));
  EXPECT_EQ(won->frames, (std::vector<int>{3, 6}));
  EXPECT_EQ(won->pixels, 400u);
  EXPECT_NEAR(won->gain(), 400 * 0.02, 1e-9);
  EXPECT_EQ(won->pixel.y, 7);
  EXPECT_FALSE(wonOf(MotionKind::FrameEarly, {3, 6}, 200, 0.016)); // not clearly
  EXPECT_FALSE(wonOf(MotionKind::FrameEarly, {3, 6}, 140, 0.03));  // as many as beside what uncovers
  EXPECT_FALSE(wonOf(MotionKind::FrameEarly, {3}, 300, 0.03));     // once, and small
  EXPECT_TRUE(wonOf(MotionKind::FrameEarly, {3}, 500, 0.03));
}

// What is made of factors or of jitter is wrong in all frames, or something else is.
TEST(MotionPairs, AreNotWonByWhatAllFramesHave) {
  EXPECT_FALSE(wonOf(MotionKind::Scaled, {3, 6}, 500, 0.05));
  EXPECT_FALSE(wonOf(MotionKind::JitterOfThis, {3, 6}, 500, 0.05));
  EXPECT_TRUE(wonOf(MotionKind::Resting, {3, 6}, 500, 0.05));
  EXPECT_TRUE(wonOf(MotionKind::OfCamera, {3, 6}, 500, 0.05));
}

// Without depth nothing says what hid a pixel; one whose motion leads to another region may have been behind
// it.
TEST(MotionPairs, AreNotOfWhatUncovers) {
  test::PaintedShot shot;
  shot.boardPx = {9.0, 0.0};
  const Diagnosis diagnosis = examine(test::paintedExamination(shot, 10, [](DoctorFrame& frame) {
    frame.depth = frame.depthView = frame.previousDepthView = {};
    frame.previousClipFromClip.reset();
    for (std::size_t i = 0; i < frame.objectId.size(); ++i) // a sky around the board, with little detail
      if (frame.objectId[i] == test::kGroundId) {
        frame.objectId[i] = 0;
        frame.luma.pixels[i] = 0.45f + 0.1f * frame.luma.pixels[i];
      }
  }));
  EXPECT_EQ(test::idsOf(diagnosis), "");
}

// A part of an object alone jumps: over the whole of it, and over all frames, its motion is right.
TEST(MotionPairs, NameTheFramesInWhichAPartJumps) {
  const Diagnosis diagnosis =
      diagnosisOf(test::kBoardId, [](const glm::vec2& motion, const glm::ivec2& pixel, int frame) {
        // The right part of the board, whose left silhouette has moved by so much.
        const bool isJump = (frame == 4 || frame == 8) && pixel.x >= 70 + static_cast<int>(3.75 * frame) + 20;
        return isJump ? motion + glm::vec2(-6.0f, 4.0f) : motion;
      });
  ASSERT_EQ(test::idsOf(diagnosis), "motionJumps");
  const Finding& finding = diagnosis.findings[0];
  ASSERT_EQ(finding.regions.size(), 1u);
  const RegionPlace& place = finding.regions[0];
  EXPECT_EQ(place.objectId, test::kBoardId);
  // What is outlined is the place in the frame that is named.
  EXPECT_TRUE(place.frame == 4 || place.frame == 8);
  EXPECT_GE(place.pixel.x, 70 + 20);
  ASSERT_FALSE(place.pixels.empty());
  EXPECT_TRUE(std::ranges::any_of(place.pixels, [&](const PixelRun& run) {
    return run.y == place.pixel.y && run.from <= place.pixel.x && place.pixel.x < run.to;
  }));
  EXPECT_NE(finding.reason.find("frames 4, 8"), std::string::npos) << finding.reason;
}

} // namespace taa::doctor
