// What squares of the picture move by, measured in painted frames whose motion is known; and lines fitted to
// it.
#include "core/doctor/flow/FlowFit.h"

#include "tests/support/doctor/FlowSquares.h"
#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace taa::doctor {
namespace {

using test::pointersTo;

const test::PaintedShot kShot;

FlowPair flowOf(const test::FrameFault& fault, int frame = 3) {
  DoctorFrame now = test::paintedFrame(kShot, frame), before = test::paintedFrame(kShot, frame - 1);
  RegionTracker tracker;
  tracker.label(before);
  const std::vector<RegionIndex> labels = tracker.label(now);
  if (fault) fault(now);
  return measureFlow({now, before}, labels, motionTrials(now.sizePx()));
}

/// Squares that move by `factors · given + offset`, and some that do not.
std::vector<FlowSquare> squaresBy(const glm::dmat2& factors, const glm::dvec2& offset, std::size_t outliers) {
  std::vector<FlowSquare> out;
  for (std::size_t i = 0; i < 60; ++i) {
    FlowSquare square;
    const auto x = static_cast<double>(i % 10), y = static_cast<double>(i / 10);
    square.given = {x - 4.0, 0.5 * y - 1.0};
    square.px = factors * square.given + offset;
    if (i % 7 == 0 && i / 7 < outliers) square.px += glm::dvec2(9.0, -7.0);
    square.errorPx = 0.01;
    out.push_back(square);
  }
  return out;
}

} // namespace

TEST(Flow, IsWhatPaintedThingsMoveBy) {
  const FlowPair flow = flowOf({});
  EXPECT_EQ(flow.frame, 3);
  ASSERT_GE(flow.squares.size(), 16u);
  for (const FlowSquare& square : flow.squares) {
    EXPECT_LT(square.offPx(), 0.2) << "around " << square.pixel.x << ", " << square.pixel.y;
    EXPECT_LT(square.errorPx, 0.2);
    EXPECT_FALSE(square.refutesGiven(0.5));
  }
}

TEST(Flow, IsTheSameWhateverIsGiven) {
  for (const glm::vec2& given : {glm::vec2(0.0f), glm::vec2(-7.0f, 11.0f)}) {
    const FlowPair flow = flowOf([&](DoctorFrame& frame) {
      for (const std::uint32_t id : {test::kGroundId, test::kBoardId})
        test::changeMotion(frame, id, [&](const glm::vec2&) { return given; });
    });
    ASSERT_GE(flow.squares.size(), 16u);
    for (const FlowSquare& square : flow.squares) {
      const bool isGround = glm::distance(square.px, kShot.cameraPx) < 0.25;
      const bool isBoard = glm::distance(square.px, kShot.cameraPx + kShot.boardPx) < 0.25;
      EXPECT_TRUE(isGround || isBoard) << square.px.x << ", " << square.px.y;
      EXPECT_TRUE(square.refutesGiven(0.5));
      EXPECT_EQ(square.given, glm::dvec2(given));
    }
  }
}

TEST(Flow, SaysNothingOfWhatIsPlainOrMarked) {
  const FlowPair plain =
      flowOf([](DoctorFrame& frame) { frame.luma.pixels.assign(frame.luma.pixels.size(), 0.3f); });
  EXPECT_TRUE(plain.squares.empty());
  const FlowPair marked = flowOf([](DoctorFrame& frame) {
    for (const std::uint32_t id : {test::kGroundId, test::kBoardId})
      test::changeMotion(frame, id, [](const glm::vec2&) { return glm::vec2(kNoPreviousPosition); });
  });
  EXPECT_TRUE(marked.squares.empty());
}

// A shadow, or what is mirrored, moves over what rests as it likes.
TEST(Flow, RefutesNothingThatDepthAndMatricesMake) {
  test::PaintedShot shadows = kShot;
  shadows.cameraPx = {7.25, 3.5};
  DoctorFrame now = test::paintedFrame(kShot, 3), before = test::paintedFrame(kShot, 2);
  RegionTracker tracker;
  tracker.label(before);
  const std::vector<RegionIndex> labels = tracker.label(now);
  now.luma = test::paintedFrame(shadows, 3).luma;
  before.luma = test::paintedFrame(shadows, 2).luma;
  std::size_t ofCamera = 0;
  for (const FlowSquare& square : measureFlow({now, before}, labels, motionTrials(now.sizePx())).squares) {
    if (!square.isOfCamera()) continue;
    ++ofCamera;
    EXPECT_FALSE(square.refutesGiven(0.5));
  }
  EXPECT_GT(ofCamera, 8u);
  now.previousClipFromClip.reset();
  std::size_t refuting = 0;
  for (const FlowSquare& square : measureFlow({now, before}, labels, motionTrials(now.sizePx())).squares)
    if (square.refutesGiven(0.5)) ++refuting;
  EXPECT_GT(refuting, 8u) << "nothing else says that they rest";
}

TEST(FlowFit, IsTheLineThatMostFollow) {
  const glm::dmat2 factors(glm::dvec2(0.85, 0.1), glm::dvec2(-0.2, -1.7));
  const glm::dvec2 offset(3.0, -2.0);
  const std::vector<FlowSquare> squares = squaresBy(factors, offset, 6);
  const auto fit = fitFlow(pointersTo(squares), false, 0.5);
  ASSERT_TRUE(fit);
  for (int column = 0; column < 2; ++column)
    for (int row = 0; row < 2; ++row) EXPECT_NEAR(fit->factors[column][row], factors[column][row], 1e-6);
  EXPECT_NEAR(fit->offsetPx.x, offset.x, 1e-6);
  EXPECT_NEAR(fit->offsetPx.y, offset.y, 1e-6);
  EXPECT_EQ(fit->followed, 54u);
  EXPECT_EQ(fit->squares, 60u);
  EXPECT_TRUE(fit->isGood());
}

// A camera whose roll is left out turns all motion; y points down.
TEST(FlowFit, SaysByWhichAngleMotionIsTurned) {
  const double angle = 0.3;
  const glm::dmat2 turn({std::cos(angle), std::sin(angle)}, {-std::sin(angle), std::cos(angle)});
  const auto of = [](const glm::dmat2& factors) {
    const std::vector<FlowSquare> squares = squaresBy(factors, {0.0, 0.0}, 2);
    return *fitFlow(pointersTo(squares), true, 0.5);
  };
  ASSERT_TRUE(turnedBy(of(turn)));
  EXPECT_NEAR(*turnedBy(of(turn)), 17.19, 0.01);
  EXPECT_FALSE(turnedBy(of(1.2 * turn)));
  EXPECT_FALSE(turnedBy(of(glm::dmat2({1.0, 0.3}, {0.3, 1.0}))));
}

// That pictures move as is given explains nothing of what is wrong.
TEST(FlowFit, ExplainsNothingWhereItIsWhatIsGiven) {
  const auto explains = [](const glm::dmat2& factors, const glm::dvec2& offset) {
    const std::vector<FlowSquare> squares = squaresBy(factors, offset, 2);
    return explaining(pointersTo(squares), 0.5).has_value();
  };
  EXPECT_FALSE(explains(glm::dmat2(1.0), {0.0, 0.0}));
  EXPECT_TRUE(explains(glm::dmat2(1.3), {0.0, 0.0}));
  EXPECT_TRUE(explains(glm::dmat2(1.0), {2.0, 0.0}));
}

TEST(FlowFit, IsNoneOfWhatIsGivenAlike) {
  std::vector<FlowSquare> squares = squaresBy(glm::dmat2(0.5), {}, 0);
  const auto scaled = fitFlow(pointersTo(squares), true, 0.5);
  ASSERT_TRUE(scaled);
  EXPECT_NEAR(scaled->factors[0][0], 0.5, 1e-9);
  EXPECT_EQ(scaled->offsetPx, glm::dvec2(0.0));
  for (FlowSquare& square : squares) square.given = {0.0, 0.0};
  EXPECT_FALSE(fitFlow(pointersTo(squares), true, 0.5));
  EXPECT_FALSE(fitFlow(pointersTo(squares), false, 0.5));
  squares.resize(11);
  EXPECT_FALSE(fitFlow(pointersTo(squares), true, 0.5)) << "too few";
}

TEST(FlowFit, IsOneFactorWhereOneMotionIsGiven) {
  std::vector<FlowSquare> squares = squaresBy(glm::dmat2(0.5), {}, 0);
  for (FlowSquare& square : squares) {
    square.given = {6.0, -2.0};
    square.px = {7.2, -2.4};
  }
  const auto fit = fitFlow(pointersTo(squares), true, 0.5);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->factors[0][0], 1.2, 1e-12);
  EXPECT_EQ(fit->factors[0][0], fit->factors[1][1]);
  EXPECT_EQ(fit->factors[1][0], 0.0);
  EXPECT_TRUE(fit->isGood());
  for (FlowSquare& square : squares) square.px = {2.4, 7.2};
  EXPECT_FALSE(fitFlow(pointersTo(squares), true, 0.5)->isGood()) << "no factor turns";
}

TEST(FlowFit, IsNotGoodWhereManyFollowAnother) {
  std::vector<FlowSquare> squares = squaresBy(glm::dmat2(0.5), {}, 0);
  for (std::size_t i = 0; i < squares.size(); i += 3)
    squares[i].px = -squares[i].given + glm::dvec2(2.0, 2.0);
  const auto fit = fitFlow(pointersTo(squares), true, 0.5);
  ASSERT_TRUE(fit);
  EXPECT_FALSE(fit->isGood());
}

// What goes one way alone fits any axes: only what varies says how these are turned.
TEST(FlowFit, IsNotTurnedByWhatHardlyVaries) {
  std::vector<FlowSquare> squares = squaresBy(glm::dmat2(1.0), glm::dvec2(0.0), 0);
  for (std::size_t i = 0; i < squares.size(); ++i) {
    const auto turn = static_cast<double>(i);
    squares[i].given = {4.0 + 0.05 * std::sin(7.0 * turn), 1.0 + 0.05 * std::cos(3.0 * turn)};
    squares[i].px = {-1.0 + 0.05 * std::cos(5.0 * turn), 3.0 + 0.05 * std::sin(2.0 * turn)};
  }
  EXPECT_FALSE(explaining(pointersTo(squares), 0.5));
  const glm::dmat2 turned(glm::dvec2(0.0, 1.0), glm::dvec2(-1.0, 0.0));
  EXPECT_TRUE(explaining(pointersTo(squaresBy(turned, glm::dvec2(0.0), 0)), 0.5));
}

} // namespace taa::doctor
