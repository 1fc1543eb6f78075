// Shapes of the box, chroma and the other color spaces (invariants 35, 42, 43).
#include "tests/support/frames/TwinInputs.h"

#include "core/taa/twin/Color.h"
#include "core/taa/twin/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace taa::twin {
namespace {

Inputs randomInputs(std::mt19937& random) {
  Inputs inputs = test::constantInputs(3, 3, glm::vec3(0.0f));
  std::uniform_real_distribution<float> level(0.0f, 4.0f);
  for (int k = 0; k < 9; ++k)
    test::setColor(inputs.color, k % 3, k / 3, {level(random), level(random), level(random)});
  return inputs;
}

Neighborhood measure(const Inputs& inputs, NeighborhoodShape shape, ColorSpace space,
                     Switch chromaShrink = Switch::Off) {
  Settings settings = test::plainSettings();
  settings.space = {space, ToneSpace::Linear};
  settings.neighborhood.shape = shape;
  settings.neighborhood.box = BoxKind::MinMax;
  settings.neighborhood.chromaShrink = chromaShrink;
  return measureNeighborhood(inputs, settings, glm::vec3(inputs.color.texel(1, 1)), {1, 1});
}

// Techniques: 8.4.
TEST(BoxNumbers, TheRoundedBoxLiesHalfwayBetweenFiveAndNine) {
  std::mt19937 random(35);
  for (int i = 0; i < 100; ++i) {
    const Inputs inputs = randomInputs(random);
    const Neighborhood five = measure(inputs, NeighborhoodShape::Cross, ColorSpace::YCoCg),
                       nine = measure(inputs, NeighborhoodShape::Square3x3, ColorSpace::YCoCg),
                       rounded = measure(inputs, NeighborhoodShape::Rounded, ColorSpace::YCoCg);
    for (int k = 0; k < 3; ++k) {
      EXPECT_LE(nine.boxMin[k], rounded.boxMin[k]);
      EXPECT_LE(rounded.boxMin[k], five.boxMin[k]);
      EXPECT_LE(five.boxMax[k], rounded.boxMax[k]);
      EXPECT_LE(rounded.boxMax[k], nine.boxMax[k]);
      EXPECT_NEAR(rounded.boxMin[k], 0.5f * (five.boxMin[k] + nine.boxMin[k]), 1e-6f);
      EXPECT_NEAR(rounded.boxMax[k], 0.5f * (five.boxMax[k] + nine.boxMax[k]), 1e-6f);
    }
  }
}

// Techniques: 10.6.
TEST(BoxNumbers, ShrunkChromaIsAnEighthOfTheLumaRangeAboutThePixel) {
  std::mt19937 random(43);
  for (int i = 0; i < 100; ++i) {
    const Inputs inputs = randomInputs(random);
    const Neighborhood n = measure(inputs, NeighborhoodShape::Square3x3, ColorSpace::YCoCg, Switch::On);
    const glm::vec3 own = toBox(glm::vec3(inputs.color.texel(1, 1)), {ColorSpace::YCoCg, ToneSpace::Linear});
    const float eighth = (n.boxMax.x - n.boxMin.x) / 8.0f;
    for (int k = 1; k < 3; ++k) {
      EXPECT_NEAR(n.boxMin[k], own[k] - eighth, 1e-6f);
      EXPECT_NEAR(n.boxMax[k], own[k] + eighth, 1e-6f);
    }
  }
}

// Manual 10.9: γ·clamp(1.1·1080/H, ¾, 1).
// Techniques: 10.9.
TEST(BoxNumbers, TallPicturesHaveATighterBox) {
  Inputs inputs = test::constantInputs(3, 3, glm::vec3(0.5f));
  Settings settings = test::plainSettings();
  settings.neighborhood.resolutionGamma = Switch::On;
  const auto gammaAt = [&](int height, float speed = 0.0f) {
    inputs.outputPx = {16, height};
    return measureNeighborhood(inputs, settings, glm::vec3(0.5f), {1, 1}, {.speed = speed}).gamma;
  };
  EXPECT_EQ(gammaAt(540), 1.0f);
  EXPECT_EQ(gammaAt(1080), 1.0f);
  EXPECT_EQ(gammaAt(1188), 1.0f);
  EXPECT_FLOAT_EQ(gammaAt(1320), 0.9f);
  EXPECT_EQ(gammaAt(1584), 0.75f);
  EXPECT_EQ(gammaAt(2160), 0.75f);
  settings.neighborhood.motionGamma = Switch::On;
  settings.neighborhood.gammaMoving = 0.5f;
  settings.neighborhood.gammaSpeed = 8.0f;
  EXPECT_EQ(gammaAt(1080, 8.0f), 0.5f);
  EXPECT_EQ(gammaAt(2160, 8.0f), 0.375f); // both γ are scaled
  settings.neighborhood.resolutionGamma = Switch::Off;
  EXPECT_EQ(gammaAt(2160), 1.0f);
}

// Techniques: 9.3.
TEST(BoxNumbers, LiftedChromaIsTwiceAsWide) {
  std::mt19937 random(42);
  std::uniform_real_distribution<float> level(-2.0f, 2.0f);
  for (int i = 0; i < 200; ++i) {
    const glm::vec3 color(level(random), level(random), level(random));
    const glm::vec3 plain = toBox(color, {ColorSpace::YCoCg, ToneSpace::Linear}),
                    lifted = toBox(color, {ColorSpace::YCoCgLifting, ToneSpace::Linear});
    EXPECT_NEAR(lifted.x, plain.x, 1e-6f);
    EXPECT_NEAR(lifted.y, 2.0f * plain.y, 1e-6f);
    EXPECT_NEAR(lifted.z, 2.0f * plain.z, 1e-6f);
  }
}

// Techniques: D7.
TEST(BoxNumbers, TheWayBackAsPrintedEndsAtWhite) {
  const SpaceSettings printed{ColorSpace::YCoCgAsPrinted, ToneSpace::Linear};
  const auto back = [](const glm::vec3& color, const SpaceSettings& space) {
    return fromBox(toBox(color, space), space);
  };
  EXPECT_EQ(back({4.0f, 2.0f, 1.0f}, printed), glm::vec3(1.0f)) << "manual §26, D7";
  EXPECT_EQ(back({4.0f, 2.0f, 1.0f}, withoutClamp(printed)), glm::vec3(4.0f, 2.0f, 1.0f));
  EXPECT_EQ(back({-1.0f, 0.25f, 0.5f}, printed), glm::vec3(0.0f, 0.25f, 0.5f));
  EXPECT_EQ(fromBox(glm::vec3(std::nanf("")), printed), glm::vec3(0.0f));
  EXPECT_EQ(toBox({4.0f, 2.0f, 1.0f}, printed), toBox({4.0f, 2.0f, 1.0f}, withoutClamp(printed)));
  // Of compressed colors it is harmless where these lie below 1, as by luma and the logarithm they need not.
  const glm::vec3 red(8.0f, 0.5f, 0.0f);
  for (const ToneSpace tone : {ToneSpace::ReinhardChannel, ToneSpace::MaxChannel, ToneSpace::Pq})
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(back(red, {ColorSpace::YCoCgAsPrinted, tone})[k], red[k], 1e-5f * red.x);
  for (const ToneSpace tone : {ToneSpace::ReinhardLuma, ToneSpace::Logarithm})
    EXPECT_LT(back(red, {ColorSpace::YCoCgAsPrinted, tone}).x, 0.9f * red.x);
}

// Techniques: 9.4.
TEST(BoxNumbers, GraysHaveNoChromaInAnySpace) {
  for (const ColorSpace space :
       {ColorSpace::YCoCg, ColorSpace::YCoCgLifting, ColorSpace::YCbCr, ColorSpace::YCoCgAsPrinted})
    for (const float level : {0.0f, 0.125f, 1.0f, 4096.0f}) {
      const glm::vec3 boxed = toBox(glm::vec3(level), {space, ToneSpace::Linear});
      EXPECT_NEAR(boxed.x, level, 1e-6f * level);
      EXPECT_NEAR(boxed.y, 0.0f, 1e-6f * level);
      EXPECT_NEAR(boxed.z, 0.0f, 1e-6f * level);
    }
}

} // namespace
} // namespace taa::twin
