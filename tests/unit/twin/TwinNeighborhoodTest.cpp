// The box of the CPU twin and the space it is in (invariants 34 to 37, 42, 55, 57).
#include "tests/support/frames/TwinInputs.h"

#include "core/taa/twin/Color.h"
#include "core/taa/twin/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <span>

namespace taa::twin {
namespace {

Inputs randomInputs(unsigned seed, float scale) {
  std::mt19937 random(seed);
  Inputs inputs = test::constantInputs(3, 3, glm::vec3(0.0f));
  std::uniform_real_distribution<float> level(0.0f, scale);
  for (int k = 0; k < 9; ++k) {
    test::setColor(inputs.color, k % 3, k / 3, {level(random), level(random), level(random)});
  }
  return inputs;
}

Neighborhood measure(const Inputs& inputs, const NeighborhoodSettings& settings, const SpaceSettings& space) {
  Settings all = test::plainSettings();
  all.neighborhood = settings;
  all.space = space;
  const glm::vec3 filtered = filterCurrent(inputs, {CurrentFilter::Gaussian, 0.22f}, {1, 1});
  return measureNeighborhood(inputs, all, filtered, {1, 1});
}

constexpr SpaceSettings kRgb{ColorSpace::Rgb, ToneSpace::Linear};
constexpr SpaceSettings kYCoCg{ColorSpace::YCoCg, ToneSpace::Linear};
constexpr SpaceSettings kToned{ColorSpace::YCoCg, ToneSpace::ReinhardLuma};

// Manual 8.8, as invariant 33: rendered with jitter j, pixel p holds what belongs to p − j.
// Techniques: 8.8.
TEST(TwinNeighborhood, TapsAtTheJitterFindTheSamplesOfARampWhereTheyWouldBeWithoutIt) {
  const auto ramp = [](float x, float y) { return 8.0f + 0.5f * x + 0.25f * y; };
  NeighborhoodSettings settings{NeighborhoodShape::Square3x3, BoxKind::MinMax, 1.0f, Switch::Off};
  const auto measuredAt = [&](const glm::vec2& jitter) {
    Inputs inputs = test::constantInputs(7, 7, glm::vec3(0.0f));
    inputs.jitterPx = jitter;
    for (int y = 0; y < 7; ++y)
      for (int x = 0; x < 7; ++x)
        test::setColor(inputs.color, x, y,
                       glm::vec3(ramp(static_cast<float>(x) - jitter.x, static_cast<float>(y) - jitter.y)));
    Settings all = test::plainSettings();
    all.neighborhood = settings;
    return measureNeighborhood(inputs, all, glm::vec3(0.0f), {3, 3});
  };
  for (const glm::vec2& jitter :
       {glm::vec2(0.25f, 0.375f), glm::vec2(-0.5f, 0.125f), glm::vec2(-0.375f, -0.25f)}) {
    settings.unjitter = Switch::On; // all products are exact
    EXPECT_EQ(measuredAt(jitter).min, glm::vec3(ramp(2.0f, 2.0f)));
    EXPECT_EQ(measuredAt(jitter).max, glm::vec3(ramp(4.0f, 4.0f)));
    EXPECT_EQ(measuredAt(jitter).mean, glm::vec3(ramp(3.0f, 3.0f)));
    settings.unjitter = Switch::Off;
    EXPECT_EQ(measuredAt(jitter).mean, glm::vec3(ramp(3.0f - jitter.x, 3.0f - jitter.y)));
  }
}

/// A ramp of 7×7, drawn with `jitter`, and what is measured around its middle; 1 m away unless it is said.
Neighborhood tapsOfARamp(const NeighborhoodInputs& moved, const glm::vec2& jitter = glm::vec2(0.0f)) {
  Inputs inputs = test::constantInputs(7, 7, glm::vec3(0.0f));
  inputs.jitterPx = jitter;
  for (int y = 0; y < 7; ++y)
    for (int x = 0; x < 7; ++x)
      test::setColor(inputs.color, x, y,
                     glm::vec3(8.0f + 0.5f * (static_cast<float>(x - 3) - jitter.x) +
                               0.25f * (static_cast<float>(y - 3) - jitter.y)));
  Settings all = test::plainSettings();
  all.neighborhood = {NeighborhoodShape::Varying, BoxKind::MinMax, 1.0f, Switch::Off};
  all.neighborhood.unjitter = jitter == glm::vec2(0.0f) ? Switch::Off : Switch::On;
  return measureNeighborhood(inputs, all, glm::vec3(0.0f), {3, 3}, moved);
}

// Manual 8.5: κ = ½ + 0.1667·sat(½/(‖v‖·z)).
// Techniques: 8.5.
TEST(TwinNeighborhood, TapsVaryWithSpeedAndDepth) {
  struct Case {
    float speed, depth, reach;
  };
  for (const auto& [speed, depth, reach] :
       {Case{0.0f, 4.0f, 0.6667f}, Case{0.125f, 4.0f, 0.6667f}, Case{0.25f, 4.0f, 0.58335f},
        Case{4.0f, 0.25f, 0.58335f}, Case{64.0f, 1.0f, 0.50130234f}, Case{8.0f, 0.0f, 0.5f},
        Case{0.0f, 0.0f, 0.5f}}) {
    const Neighborhood n = tapsOfARamp({.speed = speed, .depth = depth});
    EXPECT_FLOAT_EQ(n.tapReach, reach) << speed << " px at " << depth << " m";
    EXPECT_FLOAT_EQ(n.min.x, 8.0f - 0.75f * reach);
    EXPECT_FLOAT_EQ(n.max.x, 8.0f + 0.75f * reach);
    EXPECT_FLOAT_EQ(n.mean.x, 8.0f);
    // ±0.75 κ and ±0.25 κ: σ² = (0.5625 + 0.0625) κ²/2
    EXPECT_NEAR(n.deviation.x, std::sqrt(0.3125f) * reach, 1e-6f);
  }
}

TEST(TwinNeighborhood, TapsLieAboutWhereTheCenterLanded) {
  for (const glm::vec2& jitter :
       {glm::vec2(0.25f, 0.375f), glm::vec2(-0.5f, 0.125f), glm::vec2(0.5f, -0.5f)}) {
    const Neighborhood sky = tapsOfARamp({.speed = 1.0f}, jitter); // κ = ½: all products are exact
    EXPECT_EQ(sky.min.x, 7.625f);
    EXPECT_EQ(sky.max.x, 8.375f);
    const Neighborhood rest = tapsOfARamp({.depth = 1.0f}, jitter); // some lie beyond the next texel
    EXPECT_NEAR(rest.min.x, 7.499975f, 2e-6f);
    EXPECT_NEAR(rest.max.x, 8.500025f, 2e-6f);
  }
}

TEST(TwinNeighborhood, TheCenterIsNoneOfTheTapsThatVary) {
  Inputs inputs = test::constantInputs(3, 3, glm::vec3(0.0f));
  test::setGrays(inputs.color, {0, 0, 0, 0, 1, 0, 0, 0, 0});
  const Neighborhood n =
      measure(inputs, {NeighborhoodShape::Varying, BoxKind::MinMax, 1.0f, Switch::Off}, kRgb);
  EXPECT_EQ(n.boxMin, glm::vec3(0.25f)); // four taps of a quarter each
  EXPECT_EQ(n.boxMax, glm::vec3(0.25f));
  EXPECT_EQ(n.deviation, glm::vec3(0.0f));
  EXPECT_EQ(n.samples[4], glm::vec3(1.0f));
}

// Manual 8.7, MiniEngine: both columns of a pair have the same seven.
// Techniques: 8.7.
TEST(TwinNeighborhood, PairsOfColumnsHaveTheSameSeven) {
  Inputs inputs = test::constantInputs(7, 3, glm::vec3(0.0f));
  for (int k = 0; k < 21; ++k)
    test::setColor(inputs.color, k % 7, k / 7,
                   glm::vec3(static_cast<float>(1 << k % 7), 0.0f, 10.0f * float(k / 7)));
  Settings settings = test::plainSettings();
  settings.neighborhood.shape = NeighborhoodShape::Pairs;
  settings.neighborhood.box = BoxKind::MinMax;
  settings.space = {ColorSpace::Rgb, ToneSpace::Linear};
  for (const int column : {2, 3}) {
    const Neighborhood n = measureNeighborhood(inputs, settings, glm::vec3(0.0f), {column, 1});
    EXPECT_EQ(n.boxMin.x, 2.0f) << "columns 1 to 4";
    EXPECT_EQ(n.boxMax.x, 16.0f);
    EXPECT_FLOAT_EQ(n.mean.x, (2 + 8 + 4 + 8 + 16 + 2 + 8) / 7.0f);
    EXPECT_FLOAT_EQ(n.mean.z, 10.0f) << "two above, three level, two below";
  }
}

bool isWithin(const glm::vec3& low, const glm::vec3& value, const glm::vec3& high) {
  return clamped(value, low, high) == value;
}

TEST(TwinNeighborhood, KBrightOfNGiveTheirMeanAndDeviation) {
  const auto bound = [](NeighborhoodShape shape, const std::array<float, 9>& grays) {
    Inputs inputs = test::constantInputs(3, 3, glm::vec3(0.0f));
    test::setGrays(inputs.color, grays);
    return measure(inputs, {shape, BoxKind::Variance, 1.0f, Switch::Off}, kRgb);
  };
  // Invariant 36: μ = k/n, σ = √(k(n−k))/n; upper bounds at γ = 1: .6, .4254, .8047.
  const Neighborhood pixel5 = bound(NeighborhoodShape::Cross, {0, 0, 0, 0, 1, 0, 0, 0, 0});
  EXPECT_FLOAT_EQ(pixel5.mean.x, 0.2f);
  EXPECT_FLOAT_EQ(pixel5.deviation.x, 0.4f);
  EXPECT_FLOAT_EQ(pixel5.boxMax.x, 0.6f);
  const Neighborhood pixel9 = bound(NeighborhoodShape::Square3x3, {0, 0, 0, 0, 1, 0, 0, 0, 0});
  EXPECT_FLOAT_EQ(pixel9.mean.x, 1.0f / 9.0f);
  EXPECT_NEAR(pixel9.boxMax.x, 0.4254f, 5e-5f);
  const Neighborhood line9 = bound(NeighborhoodShape::Square3x3, {0, 1, 0, 0, 1, 0, 0, 1, 0});
  EXPECT_FLOAT_EQ(line9.mean.x, 1.0f / 3.0f);
  EXPECT_NEAR(line9.boxMax.x, 0.8047f, 5e-5f);
  // Corners are not part of the cross.
  EXPECT_EQ(bound(NeighborhoodShape::Cross, {1, 0, 1, 0, 0, 0, 1, 0, 1}).max.x, 0.0f);
}

TEST(TwinNeighborhood, ABrightPixelIsOutsideItsOwnBoxBelowTheThresholdOfGamma) {
  Inputs inputs = test::constantInputs(3, 3, glm::vec3(0.0f));
  const auto top = [&inputs](NeighborhoodShape shape, float gamma) {
    return measure(inputs, {shape, BoxKind::Variance, gamma, Switch::Off}, kRgb).boxMax.x;
  };
  test::setColor(inputs.color, 1, 1, glm::vec3(1.0f)); // γ < √((n−k)/k): 2 of 5, 2.828 of 9
  EXPECT_LT(top(NeighborhoodShape::Cross, 1.999f), 1.0f);
  EXPECT_GT(top(NeighborhoodShape::Cross, 2.001f), 1.0f);
  EXPECT_LT(top(NeighborhoodShape::Square3x3, 2.828f), 1.0f);
  EXPECT_GT(top(NeighborhoodShape::Square3x3, 2.829f), 1.0f);
  test::setGrays(inputs.color, {0, 1, 0, 0, 1, 0, 0, 1, 0}); // a line: 1.4142
  EXPECT_LT(top(NeighborhoodShape::Square3x3, 1.414f), 1.0f);
  EXPECT_GT(top(NeighborhoodShape::Square3x3, 1.4145f), 1.0f);
}

TEST(TwinNeighborhood, BoxesAreNestedAndGrowWithGamma) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    const Inputs inputs = randomInputs(seed, seed % 2 == 0 ? 1.0f : 100.0f);
    const SpaceSettings& space = seed % 3 == 0 ? kRgb : seed % 3 == 1 ? kYCoCg : kToned;
    const auto box = [&](NeighborhoodShape shape, BoxKind kind, float gamma, Switch filtered) {
      return measure(inputs, {shape, kind, gamma, filtered}, space);
    };
    const auto all = box(NeighborhoodShape::Square3x3, BoxKind::MinMax, 1.0f, Switch::Off);
    const auto cross = box(NeighborhoodShape::Cross, BoxKind::MinMax, 1.0f, Switch::Off);
    EXPECT_TRUE(isWithin(all.boxMin, cross.boxMin, cross.boxMax));
    EXPECT_TRUE(isWithin(cross.boxMin, cross.boxMax, all.boxMax));
    const auto narrow = box(NeighborhoodShape::Square3x3, BoxKind::Intersection, 0.75f, Switch::Off);
    const auto wide = box(NeighborhoodShape::Square3x3, BoxKind::Intersection, 1.25f, Switch::Off);
    EXPECT_TRUE(isWithin(all.boxMin, wide.boxMin, narrow.boxMin));
    EXPECT_TRUE(isWithin(narrow.boxMin, narrow.mean, narrow.boxMax));
    EXPECT_TRUE(isWithin(narrow.boxMax, wide.boxMax, all.boxMax));
    const auto grown = box(NeighborhoodShape::Square3x3, BoxKind::Variance, 0.1f, Switch::On);
    const glm::vec3 filtered = toBox(filterCurrent(inputs, {CurrentFilter::Gaussian, 0.22f}, {1, 1}), space);
    EXPECT_TRUE(isWithin(grown.boxMin, filtered, grown.boxMax));
  }
}

TEST(TwinNeighborhood, AConstantHasNoDeviationAndAPointForABox) {
  for (const float level : {0.0f, 1e-4f, 1.0f, 1000.0f, 65504.0f}) {
    const glm::vec3 color(level, 0.5f * level, level);
    const Inputs inputs = test::constantInputs(3, 3, color);
    for (const SpaceSettings& space : {kRgb, kYCoCg, kToned})
      for (const BoxKind kind : {BoxKind::MinMax, BoxKind::Variance, BoxKind::Intersection})
        for (const NeighborhoodShape shape :
             {NeighborhoodShape::Square3x3, NeighborhoodShape::Varying, NeighborhoodShape::Pairs}) {
          const Neighborhood n = measure(inputs, {shape, kind, 1.0f, Switch::On}, space);
          EXPECT_EQ(n.deviation, glm::vec3(0.0f));
          EXPECT_EQ(n.boxMin, n.boxMax);
          EXPECT_EQ(n.boxMin, toBox(color, space));
        }
  }
}

TEST(TwinNeighborhood, SmallDeviationsOfBrightPixelsSurvive) {
  Inputs inputs = test::constantInputs(3, 3, glm::vec3(65504.0f));
  for (int k = 0; k < 9; ++k)
    test::setColor(inputs.color, k % 3, k / 3, glm::vec3(65496.0f + static_cast<float>(k)));
  const Neighborhood n =
      measure(inputs, {NeighborhoodShape::Square3x3, BoxKind::MinMax, 1.0f, Switch::Off}, kRgb);
  // 65496 … 65504: σ² = (9² − 1)/12. E[x²] − μ² in floats would be off by hundreds.
  EXPECT_FLOAT_EQ(n.deviation.x, std::sqrt(80.0f / 12.0f));
}

// Techniques: 9.2.
TEST(TwinNeighborhood, YCoCgGoesThereAndBackAndGraysHaveNoChroma) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> level(-2.0f, 2.0f);
  for (int i = 0; i < 1000; ++i) {
    const float scale = i % 2 == 0 ? 1.0f : 32752.0f;
    const glm::vec3 c = scale * glm::vec3(level(random), level(random), level(random));
    const glm::vec3 back = fromBox(toBox(c, kYCoCg), kYCoCg);
    const float largest = std::max({std::fabs(c.x), std::fabs(c.y), std::fabs(c.z)});
    const float ulp = std::nextafter(largest, INFINITY) - largest;
    for (int k = 0; k < 3; ++k) EXPECT_LE(std::fabs(back[k] - c[k]), 2.0f * ulp); // invariant 42
  }
  EXPECT_EQ(toBox(glm::vec3(0.75f), kYCoCg), glm::vec3(0.75f, 0.0f, 0.0f));
  EXPECT_EQ(fromBox(toBox({4.0f, 2.0f, 1.0f}, kYCoCg), kYCoCg), glm::vec3(4.0f, 2.0f, 1.0f)); // not saturated
}

// Techniques: 9.5.
TEST(TwinNeighborhood, ToneSpaceGoesThereAndBackWithinItsErrorBound) {
  for (float level = 1e-4f; level < 70000.0f; level *= 3.7f) {
    const glm::vec3 c(level, 0.5f * level, 0.25f * level);
    const glm::vec3 back = fromBox(toBox(c, kToned), kToned);
    // 1 − y carries a rounding error of about 2⁻²³, seen 1 + L times larger; 4 steps of rounding.
    const float bound = 4.0f * 1.2e-7f * (1.0f + luma(c));
    for (int k = 0; k < 3; ++k) EXPECT_LE(std::fabs(back[k] - c[k]) / c[k], bound) << level;
  }
  // Beyond the curve's end the denominator stays at 10⁻⁵: finite, not negative.
  EXPECT_EQ(fromBox(glm::vec3(2.0f, 0.0f, 0.0f), kToned), glm::vec3(2.0f) / 1e-5f);
}

} // namespace
} // namespace taa::twin
