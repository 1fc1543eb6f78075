// Depth of now against that of history: where it is looked for, what a slope is, and thin features at rest
// (manual 12.1, 13.9). All predicted from the geometry that the pictures are made of.
#include "core/taa/twin/CompareDepth.h"
#include "core/settings/Settings.h"
#include "core/taa/twin/Twin.h"
#include "tests/support/frames/TwinInputs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace taa::twin {
namespace {

constexpr int kSize = 11, kMiddle = 5;
constexpr float kWall = 8.0f, kLine = 2.0f; // m
constexpr float kTolerance = 0.03f;

using DepthAt = std::function<float(int x, int y)>;

float wall(int, int) {
  return kWall;
}

/// A picture of now and one of history, everything at rest: view depths in m, 0 is the sky.
Inputs frames(const DepthAt& now, const DepthAt& then) {
  Inputs inputs = test::constantInputs(kSize, kSize, glm::vec3(0.5f));
  test::setHistory(inputs, glm::vec3(0.25f), 4.0f);
  inputs.historyMotion = Image(kSize, kSize, 2);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const float depth = now(x, y);
      inputs.depth.at(x, y)[0] = depth == 0.0f ? 0.0f : 0.1f / depth; // a near plane at 0.1 m
      inputs.previousDepth.at(x, y)[0] = depth;
      inputs.historySurface.at(x, y)[1] = then(x, y);
    }
  return inputs;
}

ValidateSettings square() {
  ValidateSettings settings;
  settings.depthTolerance = kTolerance;
  settings.depthFootprint = DepthFootprint::Square3x3;
  settings.flicker = Switch::Off;
  return settings;
}

ValidateSettings likeBalanced() {
  ValidateSettings settings;
  settings.depthTolerance = kTolerance;
  return settings;
}

DepthTest compared(const Inputs& inputs, const ValidateSettings& settings,
                   const glm::vec2& position = glm::vec2(kMiddle + 0.5f)) {
  return compareDepth(inputs, settings, {}, {kMiddle, kMiddle}, position);
}

/// The wall with a line of `width` texels from `first` on, which lies so in a dilated picture.
DepthAt column(int first, int width) {
  return [=](int x, int) { return x >= first && x < first + width ? kLine : kWall; };
}

} // namespace

// An edge that jitter moves by a texel is the same edge to all four sides.
// Techniques: 12.1.
TEST(CompareDepth, LooksAlikeToAllSides) {
  for (int k = 0; k < 9; ++k) {
    const glm::ivec2 where(kMiddle + k % 3 - 1, kMiddle + k / 3 - 1);
    const auto then = [&](int x, int y) { return glm::ivec2(x, y) == where ? kWall : kLine; };
    EXPECT_EQ(compared(frames(wall, then), square()).mismatch, 0.0f) << where.x << ' ' << where.y;
  }
  for (const glm::ivec2 way : {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)}) {
    const auto beyond = [&](int steps) { // nearer everything until `steps` texels along the way
      return [way, steps](int x, int y) {
        return (x - kMiddle) * way.x + (y - kMiddle) * way.y >= steps ? kWall : kLine;
      };
    };
    EXPECT_FALSE(compared(frames(wall, beyond(1)), square()).isOther) << way.x << ' ' << way.y;
    EXPECT_TRUE(compared(frames(wall, beyond(2)), square()).isOther) << way.x << ' ' << way.y;
    EXPECT_FALSE(compared(frames(wall, beyond(1)), likeBalanced()).isOther) << way.x << ' ' << way.y;
    EXPECT_TRUE(compared(frames(wall, beyond(2)), likeBalanced()).isOther) << way.x << ' ' << way.y;
  }
}

// What uncovers the wall moves against it: then a texel beside the position is no proof of the wall.
TEST(CompareDepth, LooksOnlyWhereABilinearTapReadsWhereThingsPart) {
  const auto seenAt = [](int column, float q, const glm::vec2& then) {
    Inputs inputs = frames(wall, [=](int x, int) { return x == column ? kWall : kLine; });
    for (int y = 0; y < kSize; ++y) inputs.historyMotion.at(kMiddle, y)[0] = then.x;
    return !compared(inputs, likeBalanced(), {q, kMiddle + 0.5f}).isOther;
  };
  const glm::vec2 still(0.0f), slow(0.5f, 0.0f), fast(0.51f, 0.0f);
  EXPECT_TRUE(seenAt(kMiddle + 1, kMiddle + 0.5f, still));
  EXPECT_TRUE(seenAt(kMiddle + 1, kMiddle + 0.5f, slow)) << "as much as jitter moves samples";
  EXPECT_FALSE(seenAt(kMiddle + 1, kMiddle + 0.5f, fast));
  EXPECT_TRUE(seenAt(kMiddle, kMiddle + 0.5f, fast));
  EXPECT_TRUE(seenAt(kMiddle + 1, kMiddle + 0.75f, fast)) << "read, with a quarter of the weight";
  EXPECT_FALSE(seenAt(kMiddle - 1, kMiddle + 0.75f, fast));
  Inputs without = frames(wall, [](int x, int) { return x == kMiddle + 1 ? kWall : kLine; });
  without.historyMotion = {};
  EXPECT_TRUE(compared(without, likeBalanced()).isOther) << "no motion is kept: nothing is known to rest";
}

// A wire at rest has the wall behind it, however something moves beside it.
TEST(CompareDepth, AsksWhatHistoryShowsWhetherItMoved) {
  Inputs inputs = frames(wall, [](int x, int) { return x == kMiddle + 1 ? kWall : kLine; });
  for (int y = 0; y < kSize; ++y) inputs.historyMotion.at(kMiddle + 1, y)[0] = 9.0f;
  EXPECT_FALSE(compared(inputs, likeBalanced()).isOther);
  EXPECT_TRUE(compared(inputs, likeBalanced(), {kMiddle + 0.75f, kMiddle + 0.5f}).mismatch == 0.0f) << "read";
  for (int y = 0; y < kSize; ++y) inputs.historySurface.at(kMiddle + 1, y)[1] = kLine;
  for (int y = 0; y < kSize; ++y) inputs.historySurface.at(kMiddle - 1, y)[1] = kWall;
  EXPECT_TRUE(compared(inputs, likeBalanced(), {kMiddle + 0.75f, kMiddle + 0.5f}).isOther) << "it moved away";
}

// The wire of builtin:fence at 4.70 m before 75 and 59 m: its neighbors are other surfaces, and no slope.
TEST(CompareDepth, AWireHasNoSlope) {
  const auto wire = [](int x, int) { return x < kMiddle ? 75.0f : x == kMiddle ? 4.7f : 59.0f; };
  const Inputs inputs = frames(wire, wall);
  EXPECT_EQ(depthSlope(inputs, {kMiddle, kMiddle}), 0.0f);
  EXPECT_EQ(compared(inputs, square()).allowed, kTolerance);
  EXPECT_TRUE(compared(frames(wire, [](int, int) { return 54.54f; }), square()).isOther) << "1,060 % off";
  const auto beforeSky = [](int x, int) { return x < kMiddle ? 0.0f : x == kMiddle ? 4.7f : 59.0f; };
  EXPECT_EQ(depthSlope(frames(beforeSky, wall), {kMiddle, kMiddle}), 0.0f);
}

// A surface that goes on from one neighbor to the other has the smaller step's slope; a silhouette beside it
// does not add to it.
TEST(CompareDepth, ASurfaceHasItsOwnSlope) {
  const auto receding = [](int, int y) { return 16.0f - static_cast<float>(y); };
  const auto beforeSky = [&](int x, int y) { return y < kMiddle ? 0.0f : receding(x, y); };
  const auto behindAPost = [&](int x, int y) { return y > kMiddle ? 1.0f : receding(x, y); };
  const float slope = 1.0f; // m a texel, of 11 m; 0.1/d rounds
  EXPECT_NEAR(depthSlope(frames(receding, wall), {kMiddle, kMiddle}), slope, 1e-5f);
  EXPECT_NEAR(depthSlope(frames(beforeSky, wall), {kMiddle, kMiddle}), slope, 1e-5f);
  EXPECT_NEAR(depthSlope(frames(behindAPost, wall), {kMiddle, kMiddle}), slope, 1e-5f);
  EXPECT_NEAR(compared(frames(receding, wall), square()).allowed, kTolerance + 2.0f * slope / 11.0f, 1e-6f);
}

// The slope is that of the sample whose depth is expected, not of the pixel that follows it.
TEST(CompareDepth, TakesTheSlopeOfTheDilatedSample) {
  const auto ground = [](int x, int y) {
    return x == kMiddle + 1 ? 2.0f : 60.0f - 8.0f * static_cast<float>(y);
  };
  DilatedMotion dilated;
  dilated.offset = {1, 0};
  const DepthTest result =
      compareDepth(frames(ground, wall), square(), dilated, {kMiddle, kMiddle}, glm::vec2(kMiddle + 0.5f));
  EXPECT_EQ(result.expected, 2.0f);
  EXPECT_EQ(result.allowed, kTolerance);
}

// Techniques: 12.1.
TEST(CompareDepth, OnlyWhatIsNearerCanHaveHiddenASurface) {
  ValidateSettings settings = square();
  const auto at = [](float depth) { return [depth](int, int) { return depth; }; };
  const auto isOther = [&](float now, float then) {
    return compared(frames(at(now), at(then)), settings).isOther;
  };
  for (const DepthDirection direction : {DepthDirection::Both, DepthDirection::Nearer}) {
    settings.depthDirection = direction;
    const bool isBoth = direction == DepthDirection::Both;
    EXPECT_TRUE(isOther(4.0f, 3.0f));
    EXPECT_EQ(isOther(4.0f, 5.0f), isBoth);
    EXPECT_TRUE(isOther(0.0f, 5.0f)) << "the sky was hidden";
    EXPECT_EQ(isOther(5.0f, 0.0f), isBoth);
    EXPECT_FALSE(isOther(0.0f, 0.0f));
  }
}

// A line narrower than a texel is three texels wide once dilated, or not there at all.
// Techniques: 13.9.
TEST(CompareDepth, ALineThatAFrameMissesAtRestIsFlicker) {
  for (int offset = -1; offset <= 1; ++offset) { // of the pixel from the middle of the line
    const DepthTest gone = compared(frames(wall, column(kMiddle - 1 + offset, 3)), likeBalanced());
    EXPECT_EQ(gone.isFlicker, offset == 0) << "beside it the wall is in reach";
    EXPECT_FALSE(gone.isOther) << offset;
  }
  const DepthTest there = compared(frames(column(kMiddle, 1), wall), likeBalanced());
  EXPECT_TRUE(there.isFlicker);
  EXPECT_FALSE(there.isOther);
  EXPECT_EQ(there.expected, kLine);
  EXPECT_EQ(there.stored, kWall);
  ValidateSettings off = likeBalanced();
  off.flicker = Switch::Off;
  EXPECT_TRUE(compared(frames(column(kMiddle, 1), wall), off).isOther);
}

TEST(CompareDepth, FlickerIsAlikeAlongAllAxes) {
  using Line = std::function<bool(int dx, int dy)>;
  for (const Line& line : {Line([](int dx, int) { return std::abs(dx) <= 1; }),
                           Line([](int, int dy) { return std::abs(dy) <= 1; }),
                           Line([](int dx, int dy) { return std::abs(dx + dy) <= 2; }),
                           Line([](int dx, int dy) { return std::abs(dx - dy) <= 2; })}) {
    const auto then = [&](int x, int y) { return line(x - kMiddle, y - kMiddle) ? kLine : kWall; };
    EXPECT_TRUE(compared(frames(wall, then), likeBalanced()).isFlicker);
  }
}

// What is wider than a line was no matter of jitter: it has gone, and its history would be a ghost.
TEST(CompareDepth, WhatIsWideIsNoFlicker) {
  for (int first = kMiddle - 3; first <= kMiddle - 1; ++first) {
    const DepthTest gone = compared(frames(wall, column(first, 5)), likeBalanced());
    EXPECT_TRUE(gone.isOther) << first;
    EXPECT_FALSE(gone.isFlicker) << first;
  }
  const DepthTest there = compared(frames(column(kMiddle - 2, 5), wall), likeBalanced());
  EXPECT_TRUE(there.isOther);
}

TEST(CompareDepth, WhatMovesIsNoFlicker) {
  Inputs inputs = frames(wall, column(kMiddle - 1, 3));
  for (int y = 0; y < kSize; ++y) inputs.historyMotion.at(kMiddle, y)[1] = 0.75f; // the line moved down
  EXPECT_TRUE(compared(inputs, likeBalanced()).isOther);
  ValidateSettings lenient = likeBalanced();
  lenient.restLimit = 0.75f;
  EXPECT_TRUE(compared(inputs, lenient).isFlicker);
  DilatedMotion along; // all moves as it did: a camera that pans is at rest too
  along.motion = {0.0f, 0.75f};
  for (float& value : inputs.historyMotion.pixels) value = 0.0f;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) inputs.historyMotion.at(x, y)[1] = 0.75f;
  EXPECT_TRUE(
      compareDepth(inputs, likeBalanced(), along, {kMiddle, kMiddle}, glm::vec2(kMiddle + 0.5f)).isFlicker);
}

// Source 000: depth differs and nothing moves, so no clamp and a smaller α.
// Techniques: 13.9.
TEST(CompareDepth, FlickerIsNotRectifiedAndWeighsLess) {
  const Inputs inputs = frames(column(kMiddle, 1), wall);
  Settings settings = test::plainSettings();
  settings.rectify.method = RectifyMethod::Clamp;
  settings.validate = likeBalanced();
  settings.weight.source = AlphaSource::HistoryLength;
  settings.weight.minimum = 0.1f;
  const auto value = [&](IntermediateId id) {
    return twin::at(resolvePixel(inputs, settings, kMiddle, kMiddle), id).x;
  };
  settings.rectify.flickerStrength = 0.0f;
  settings.weight.flickerShare = 0.5f;
  EXPECT_EQ(value(IntermediateId::geometricFlicker), 1.0f);
  EXPECT_EQ(value(IntermediateId::rejectReason), 0.0f);
  EXPECT_EQ(value(IntermediateId::historyRectified), 0.25f) << "all around is 0.5";
  EXPECT_EQ(value(IntermediateId::alpha), 0.1f) << "half of 1/(4 + 1)";
  settings.rectify.flickerStrength = 0.5f;
  settings.weight.flickerShare = 1.0f;
  EXPECT_EQ(value(IntermediateId::historyRectified), 0.375f);
  EXPECT_EQ(value(IntermediateId::alpha), 0.2f);
  settings.validate.flicker = Switch::Off;
  EXPECT_EQ(value(IntermediateId::geometricFlicker), 0.0f);
  EXPECT_EQ(value(IntermediateId::rejectReason), 4.0f);
  EXPECT_EQ(value(IntermediateId::alpha), 1.0f);
}

} // namespace taa::twin
