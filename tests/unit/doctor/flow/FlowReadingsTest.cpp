// Explanations against squares that move by a known one.
#include "core/doctor/flow/FlowReadings.h"

#include "tests/support/doctor/FlowSquares.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace taa::doctor {
namespace {

using test::pointersTo;

constexpr glm::ivec2 kSizePx{160, 96};

std::size_t indexOf(MotionKind kind) {
  const std::vector<MotionTrial> trials = motionTrials(kSizePx);
  return static_cast<std::size_t>(std::ranges::find(trials, kind, &MotionTrial::kind) - trials.begin());
}

/// Squares of which a share moves as one explanation has it, to `noisePx`; all others say nothing.
std::vector<FlowSquare> squaresUnder(MotionKind kind, double share, double noisePx) {
  constexpr std::size_t kCount = 40;
  std::vector<FlowSquare> out;
  for (std::size_t i = 0; i < kCount; ++i) {
    FlowSquare square;
    const auto turn = static_cast<double>(i);
    square.given = {3.0 + 0.1 * turn, -2.0};
    const glm::vec2 by(std::sin(turn), 4.0);
    square.byTrial.assign(motionTrials(kSizePx).size(), glm::vec2(std::numeric_limits<float>::quiet_NaN()));
    square.byTrial[0] = glm::vec2(square.given);
    square.byTrial[indexOf(kind)] = by;
    const glm::dvec2 noise = noisePx * glm::dvec2(std::cos(3.0 * turn), std::sin(5.0 * turn));
    square.px = noise + (turn < share * kCount ? glm::dvec2(by) : square.given);
    square.errorPx = 0.02;
    out.push_back(square);
  }
  return out;
}

} // namespace

TEST(FlowReadings, AreFoundWhereTheyLeaveNoMoreThanIsHealthy) {
  const std::vector<FlowSquare> squares = squaresUnder(MotionKind::FrameLate, 1.0, 0.03);
  const std::vector<MotionTrial> trials = motionTrials(kSizePx);
  EXPECT_EQ(bestReadings(pointersTo(squares), trials, 0.03),
            std::vector<std::size_t>{indexOf(MotionKind::FrameLate)});
  EXPECT_NEAR(leftPx(pointersTo(squares), indexOf(MotionKind::FrameLate)), 0.03, 0.015);
}

TEST(FlowReadings, AreNotFoundWhereTheyLeaveMore) {
  const std::vector<FlowSquare> squares = squaresUnder(MotionKind::FrameLate, 1.0, 0.6);
  EXPECT_TRUE(bestReadings(pointersTo(squares), motionTrials(kSizePx), 0.03).empty());
  const std::vector<FlowSquare> right = squaresUnder(MotionKind::FrameLate, 0.0, 0.03);
  EXPECT_TRUE(bestReadings(pointersTo(right), motionTrials(kSizePx), 0.03).empty()) << "what is given fits";
}

TEST(FlowReadings, AreBorneOutByMostSquaresOrBySomeOrByNone) {
  const std::size_t trial = indexOf(MotionKind::LacksCamera);
  const auto says = [trial](double share) {
    const std::vector<FlowSquare> squares = squaresUnder(MotionKind::LacksCamera, share, 0.03);
    return borneOut(pointersTo(squares), trial);
  };
  EXPECT_EQ(says(1.0), BorneOut::Yes);
  EXPECT_EQ(says(0.5), BorneOut::Partly);
  EXPECT_EQ(says(0.1), BorneOut::No);
  const std::vector<FlowSquare> others = squaresUnder(MotionKind::FrameLate, 1.0, 0.03);
  EXPECT_EQ(borneOut(pointersTo(others), trial), BorneOut::Open) << "of which it says nothing";
}

} // namespace taa::doctor
