// The length of motion that is shorter than a pixel, fitted to painted pictures that move by a known one.
#include "core/doctor/flow/FlowLength.h"

#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace taa::doctor {
namespace {

using test::kPaintedPx;
using test::PaintedShot;

constexpr int kFrames = 8;
// Of the factor: reading between pixels softens, which pulls a fit of some pixels' motion a little.
constexpr double kFittedTo = 0.01;

using MotionChange = std::function<glm::vec2(const glm::vec2&)>;

std::optional<FittedLength> lengthOf(const PaintedShot& shot, const MotionChange& change,
                                     std::uint32_t onlyObject = 0) {
  std::vector<FlowPair> pairs;
  RegionTracker tracker;
  DoctorFrame before = test::paintedFrame(shot, 0);
  for (int frame = 1; frame < kFrames; ++frame) {
    DoctorFrame now = test::paintedFrame(shot, frame);
    for (const std::uint32_t id : {0u, test::kGroundId, test::kBoardId})
      test::changeMotion(now, id, [&](const glm::vec2& motion) {
        return onlyObject == 0 || id == onlyObject ? change(motion) : glm::vec2(0.0f);
      });
    pairs.push_back(measureFlow({now, before}, tracker.label(now), motionTrials(kPaintedPx)));
    before = std::move(now);
  }
  return fittedLength(pairs);
}

glm::vec2 sizePx() {
  return glm::vec2(kPaintedPx);
}

void expectFactors(const std::optional<FittedLength>& length, const glm::dvec2& expected) {
  ASSERT_TRUE(length);
  for (int axis = 0; axis < 2; ++axis) {
    ASSERT_TRUE(length->factor[axis]) << axis;
    EXPECT_NEAR(*length->factor[axis] / expected[axis], 1.0, kFittedTo) << axis;
    EXPECT_GT(length->error[axis], 0.0);
  }
}

} // namespace

TEST(FlowLength, IsThatOfThePictureWhereMotionIsAShareOfIt) {
  const auto uv = lengthOf({}, [](const glm::vec2& m) { return m / sizePx(); });
  expectFactors(uv, {160.0, 96.0});
  const MotionTrial trial = trialOf(*uv, kPaintedPx);
  EXPECT_EQ(trial.kind, MotionKind::OtherUnit);
  EXPECT_EQ(trial.factor, glm::vec2(160.0f, 96.0f));
  EXPECT_FALSE(trial.isDevice);
}

TEST(FlowLength, IsHalfThatInDeviceCoordinatesWhoseYPointsUp) {
  const auto ndc = lengthOf({}, [](const glm::vec2& m) { return glm::vec2(2.0f, -2.0f) * m / sizePx(); });
  expectFactors(ndc, {80.0, -48.0});
  const MotionTrial trial = trialOf(*ndc, kPaintedPx);
  EXPECT_EQ(trial.factor, glm::vec2(80.0f, -48.0f));
  EXPECT_TRUE(trial.isDevice);
}

TEST(FlowLength, OfAnotherDirectionIsNegative) {
  expectFactors(lengthOf({}, [](const glm::vec2& m) { return -m / sizePx(); }), {-160.0, -96.0});
}

// No number of the picture lies within the error: it is told as it was measured.
TEST(FlowLength, OfNoUnitIsMeasured) {
  const auto length = lengthOf({}, [](const glm::vec2& m) { return m / 20.0f; });
  expectFactors(length, {20.0, 20.0});
  const MotionTrial trial = trialOf(*length, kPaintedPx);
  EXPECT_EQ(trial.kind, MotionKind::Scaled);
  EXPECT_NEAR(trial.factor.x, 20.0f, 0.2f);
  EXPECT_NEAR(trial.factor.y, 20.0f, 0.2f);
}

TEST(FlowLength, IsMeasuredByAnObjectAlone) {
  PaintedShot shot;
  shot.cameraPx = glm::dvec2(0.0);
  expectFactors(lengthOf(shot, [](const glm::vec2& m) { return m / sizePx(); }), {160.0, 96.0});
}

// Nothing moves along y: what its factor is, and its sign, is not known, and x alone says the unit.
TEST(FlowLength, HasNoFactorOfAnAxisAlongWhichNothingMoves) {
  PaintedShot shot;
  shot.cameraPx = {3.0, 0.0};
  shot.boardPx = {1.5, 0.0};
  for (const float rounding : {0.0f, 1e-6f}) { // of a projection
    const auto length =
        lengthOf(shot, [rounding](const glm::vec2& m) { return m / sizePx() + glm::vec2(0.0f, rounding); });
    ASSERT_TRUE(length && length->factor[0]);
    EXPECT_NEAR(*length->factor[0], 160.0, 160.0 * kFittedTo);
    EXPECT_FALSE(length->factor[1]) << rounding;
    EXPECT_EQ(trialOf(*length, kPaintedPx).factor, glm::vec2(160.0f, 96.0f));
  }
}

// A fifteenth of a pixel up or down is known to a part of itself, by hundreds of squares.
TEST(FlowLength, MeasuresAnAxisAlongWhichHardlyAnythingMoves) {
  PaintedShot shot;
  shot.cameraPx = {3.0, 0.07};
  shot.boardPx = {1.5, 0.0};
  const auto length = lengthOf(shot, [](const glm::vec2& m) { return m / sizePx(); });
  ASSERT_TRUE(length && length->factor[0]);
  EXPECT_NEAR(*length->factor[0], 160.0, 160.0 * kFittedTo);
  ASSERT_TRUE(length->factor[1]);
  EXPECT_NEAR(*length->factor[1], 96.0, 4.0 * length->error[1]);
}

TEST(FlowLength, IsNotAskedOfMotionThatFits) {
  const MotionChange asItIs = [](const glm::vec2& m) { return m; };
  EXPECT_FALSE(lengthOf({}, asItIs)) << "longer than a pixel";
  PaintedShot slow;
  slow.cameraPx = {0.3, -0.2};
  slow.boardPx = {0.25, 0.4};
  EXPECT_FALSE(lengthOf(slow, asItIs)) << "shorter, and right";
  EXPECT_FALSE(lengthOf({}, [](const glm::vec2&) { return glm::vec2(0.0f); })) << "none is written";
}

// What the camera moves has motion of another cause: no factor makes the pictures of it.
TEST(FlowLength, IsNotFoundWhereMotionIsOfSomethingElse) {
  int turn = 0;
  EXPECT_FALSE(lengthOf({}, [&](const glm::vec2&) {
    ++turn;
    return 0.4f *
           glm::vec2(std::sin(0.7f * static_cast<float>(turn)), std::cos(1.3f * static_cast<float>(turn)));
  }));
  PaintedShot still;
  still.cameraPx = still.boardPx = glm::dvec2(0.0);
  EXPECT_FALSE(lengthOf(still, [](const glm::vec2&) { return glm::vec2(0.2f, -0.1f); })) << "nothing moves";
}

// A size of the picture within three standard errors, and one beside it.
TEST(FlowLength, NamesAUnitOnlyWithinItsError) {
  FittedLength length;
  length.factor[0] = 162.0;
  length.factor[1] = 96.5;
  length.error[0] = 0.7;
  length.error[1] = 0.4;
  EXPECT_EQ(trialOf(length, kPaintedPx).kind, MotionKind::OtherUnit);
  length.error[0] = 0.6;
  const MotionTrial beside = trialOf(length, kPaintedPx);
  EXPECT_EQ(beside.kind, MotionKind::Scaled);
  EXPECT_EQ(beside.factor, glm::vec2(162.0f, 96.5f));
}

} // namespace taa::doctor
