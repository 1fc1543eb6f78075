// Validation and α of the CPU twin (manual 5.1, 12.1, 13.1, 13.3).
#include "tests/support/frames/TwinInputs.h"

#include "core/taa/twin/Stages.h"

#include <gtest/gtest.h>

namespace taa::twin {
namespace {

/// 3×3, nothing else than depth and the border.
ValidateSettings square(OffScreen offScreen, Switch depth) {
  ValidateSettings settings{offScreen, depth, 0.03f, 0.0f};
  settings.depthFootprint = DepthFootprint::Square3x3;
  settings.flicker = Switch::Off;
  return settings;
}
const ValidateSettings kOn = square(OffScreen::Reject, Switch::On);

Inputs withHistory(float expected, float stored) {
  Inputs inputs = test::constantInputs(4, 4, glm::vec3(0.5f));
  test::setHistory(inputs, glm::vec3(0.5f), 3.0f);
  for (float& depth : inputs.previousDepth.pixels) depth = expected;
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) inputs.historySurface.at(x, y)[1] = stored;
  }
  return inputs;
}

Validity validate(const Inputs& inputs, const ValidateSettings& settings = kOn) {
  const Reprojection atRest{{1.5f, 1.5f}, true, false};
  return validateHistory(inputs, settings, {}, atRest, atRest.position, {1, 1});
}

// Techniques: 12.1.
TEST(TwinValidate, ComparesDepthsRelativeToWhatIsExpected) {
  EXPECT_EQ(validate(withHistory(4.0f, 3.0f)).depthMismatch, 0.25f);
  EXPECT_EQ(validate(withHistory(4.0f, 5.0f)).depthMismatch, 0.25f);
  EXPECT_EQ(validate(withHistory(4.0f, 3.0f)).reason, RejectReason::Depth);
  EXPECT_EQ(validate(withHistory(64.0f, 63.0f)).reason, RejectReason::Kept); // 1/64 < τ
  EXPECT_EQ(validate(withHistory(4.0f, 3.0f), square(OffScreen::Reject, Switch::Off)).reason,
            RejectReason::Kept);
}

// Rows at view depths 2, 4, 6, … m, as ground that recedes; depth terms of a near plane at 1 m: z = 1/d.
Inputs receding() {
  Inputs inputs = withHistory(4.0f, 5.0f);
  inputs.depthTerms = {0.0f, 1.0f, -1.0f, 0.0f};
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) inputs.depth.at(x, y)[0] = 1.0f / (2.0f * static_cast<float>(y + 1));
  }
  return inputs;
}

TEST(TwinValidate, AllowsMoreWhereTheSurfaceRecedes) {
  ValidateSettings settings = kOn;
  EXPECT_EQ(validate(receding(), settings).depthAllowed, 0.03f);
  EXPECT_EQ(validate(receding(), settings).reason, RejectReason::Depth);
  settings.slopeAllowance = 2.0f;
  EXPECT_FLOAT_EQ(validate(receding(), settings).depthAllowed, 0.03f + 2.0f * 2.0f / 4.0f); // 1/d rounds 6 m
  EXPECT_EQ(validate(receding(), settings).reason, RejectReason::Kept);
}

TEST(TwinValidate, TakesTheSlopeFromTheSideWithoutASilhouette) {
  ValidateSettings settings = kOn;
  settings.slopeAllowance = 2.0f;
  Inputs inputs = receding();
  for (int x = 0; x < 4; ++x) inputs.depth.at(x, 0)[0] = 1.0f; // something 3 m before row 1
  EXPECT_FLOAT_EQ(validate(inputs, settings).depthAllowed, 0.03f + 2.0f * 2.0f / 4.0f);
  for (int x = 0; x < 4; ++x)
    inputs.depth.at(x, 0)[0] = inputs.depth.at(x, 2)[0] = 0.0f; // sky above and below
  EXPECT_EQ(validate(inputs, settings).depthAllowed, 0.03f);
}

TEST(TwinValidate, TheSkyMatchesOnlyTheSky) {
  EXPECT_EQ(validate(withHistory(0.0f, 0.0f)).depthMismatch, 0.0f);
  EXPECT_EQ(validate(withHistory(0.0f, 5.0f)).depthMismatch, 1.0f);
  EXPECT_EQ(validate(withHistory(5.0f, 0.0f)).depthMismatch, 1.0f);
}

TEST(TwinValidate, TakesTheBestOfTheNineTexelsAround) {
  Inputs inputs = withHistory(4.0f, 8.0f);
  inputs.historySurface.at(0, 2)[1] = 4.0f;
  EXPECT_EQ(validate(inputs).depthMismatch, 0.0f); // around texel 1: 0 to 2
  inputs.historySurface.at(0, 2)[1] = 8.0f;
  inputs.historySurface.at(3, 1)[1] = 4.0f;
  EXPECT_EQ(validate(inputs).depthMismatch, 1.0f); // texel 3 is not among them
  inputs.historySurface.at(1, 2)[1] = 3.0f;
  inputs.historySurface.at(2, 1)[1] = 5.0f; // equally far: the first in reading order
  EXPECT_EQ(validate(inputs).historyDepth, 5.0f);
}

TEST(TwinValidate, GivesTheFirstReasonThatApplies) {
  Inputs inputs = withHistory(4.0f, 8.0f);
  const Reprojection off{{-3.0f, 1.5f}, false, false};
  const Reprojection behind{{-3.0f, 1.5f}, false, true};
  const auto reason = [&inputs](const Reprojection& where, const ValidateSettings& settings) {
    return validateHistory(inputs, settings, {}, where, where.position, {1, 1}).reason;
  };
  EXPECT_EQ(reason(behind, kOn), RejectReason::NoPrevious);
  EXPECT_EQ(reason(off, kOn), RejectReason::OffScreen);
  EXPECT_EQ(reason(off, square(OffScreen::Keep, Switch::On)), RejectReason::Depth);
  EXPECT_EQ(reason(off, square(OffScreen::Keep, Switch::Off)), RejectReason::Kept);
  inputs.historyColor = {};
  EXPECT_EQ(reason(behind, kOn), RejectReason::NoHistory);
}

TEST(TwinWeight, TakesTheLargestOfItsTerms) {
  const WeightSettings length{AlphaSource::HistoryLength, 0.5f, 0.1f};
  EXPECT_EQ(blendWeight(length, 3.0f, 0.0f).alpha, 0.25f);
  EXPECT_EQ(blendWeight(length, 99.0f, 0.0f).alpha, 0.1f);
  EXPECT_EQ(blendWeight(length, 99.0f, 1.0f).alpha, 1.0f);
  EXPECT_EQ(blendWeight(length, 0.0f, 1.0f).base, 1.0f);
  const WeightSettings constant{AlphaSource::Constant, 0.05f, 0.1f};
  EXPECT_EQ(blendWeight(constant, 3.0f, 0.0f).alpha, 0.05f); // the floor is not for constants
  EXPECT_EQ(blendWeight(constant, 3.0f, 1.0f).alpha, 1.0f);
}

} // namespace
} // namespace taa::twin
