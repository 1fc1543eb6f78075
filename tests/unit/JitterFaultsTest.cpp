// Jitter with faults, from the formula of each: what is drawn and what is reported.
#include "core/render/faults/FaultySource.h"

#include <gtest/gtest.h>

#include <glm/vec2.hpp>

#include <utility>
#include <vector>

namespace taa {
namespace {

/// A sequence whose frames are all told from each other.
glm::vec2 sequence(int frame) {
  const auto n = static_cast<float>(frame);
  return {0.5f - 0.0625f * n, -0.25f + 0.03125f * n};
}

FaultyJitter at(const FaultSettings& faults, int frame, bool isDrawn = true) {
  return faultyJitter(faults, sequence, frame, isDrawn);
}

TEST(JitterFaults, NoneLeaveWhatIsDrawnAndReported) {
  for (const bool isDrawn : {false, true})
    for (int frame = 0; frame < 8; ++frame) {
      const FaultyJitter jitter = at({}, frame, isDrawn);
      EXPECT_EQ(jitter.applied, sequence(frame));
      EXPECT_EQ(jitter.reported, sequence(frame));
    }
}

TEST(JitterFaults, OfTheReportLeaveThePicture) {
  const glm::vec2 j = sequence(3);
  const std::vector<std::pair<JitterFault, glm::vec2>> expected{
      {JitterFault::NegatedX, {-j.x, j.y}}, {JitterFault::NegatedY, {j.x, -j.y}},
      {JitterFault::Negated, -j},           {JitterFault::Swapped, {j.y, j.x}},
      {JitterFault::Unreported, {0, 0}},    {JitterFault::Late, sequence(2)},
      {JitterFault::Early, sequence(4)}};
  for (const auto& [fault, reported] : expected)
    for (const bool isDrawn : {false, true}) {
      FaultSettings faults;
      faults.jitter = fault;
      EXPECT_EQ(at(faults, 3, isDrawn).reported, reported) << static_cast<int>(fault);
      EXPECT_EQ(at(faults, 3, isDrawn).applied, j) << static_cast<int>(fault);
    }
  FaultSettings late;
  late.jitter = JitterFault::Late;
  EXPECT_EQ(at(late, 0).reported, sequence(0)) << "nothing was before";
}

TEST(JitterFaults, ScaleWhatIsDrawnAndWhatIsReportedApart) {
  FaultSettings faults;
  faults.jitterReported = 0.5f;
  EXPECT_EQ(at(faults, 5).reported, 0.5f * sequence(5));
  EXPECT_EQ(at(faults, 5).applied, sequence(5));
  faults = {};
  faults.jitterApplied = 0.0f;
  EXPECT_EQ(at(faults, 5).reported, sequence(5));
  EXPECT_EQ(at(faults, 5).applied, glm::vec2(0.0f));
}

TEST(JitterFaults, RepeatAndShiftTheSequenceItself) {
  FaultSettings faults;
  faults.jitterPeriod = 2;
  faults.jitterMeanX = 0.25f;
  for (int frame = 0; frame < 6; ++frame) {
    const glm::vec2 j = sequence(frame % 2) + glm::vec2(0.25f, 0.0f);
    EXPECT_EQ(at(faults, frame).applied, j);
    EXPECT_EQ(at(faults, frame).reported, j);
    EXPECT_EQ(at(faults, frame, false).applied, sequence(frame)) << "a capture is drawn already";
    EXPECT_EQ(at(faults, frame, false).reported, sequence(frame));
  }
}

TEST(JitterFaults, KeepToTheirFrames) {
  FaultSettings faults;
  faults.jitter = JitterFault::Negated;
  faults.firstFrame = 2;
  faults.lastFrame = 3;
  for (int frame = 0; frame < 6; ++frame) {
    const bool isFaulty = frame == 2 || frame == 3;
    EXPECT_EQ(isFaultyFrame(faults, frame), isFaulty);
    EXPECT_EQ(at(faults, frame).reported, isFaulty ? -sequence(frame) : sequence(frame));
  }
}

} // namespace
} // namespace taa
