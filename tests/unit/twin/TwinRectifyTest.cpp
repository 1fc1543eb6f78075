// Rectification of the CPU twin (invariants 38 to 41).
#include "tests/support/frames/TwinInputs.h"

#include "core/taa/twin/Color.h"
#include "core/taa/twin/Stages.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace taa::twin {
namespace {

constexpr auto kMethods = {RectifyMethod::Clamp, RectifyMethod::ClipToCenter, RectifyMethod::ClipToFiltered};

/// A box, a history color around it and a target in it.
struct Case {
  glm::vec3 low, high, history, target;
};

std::vector<Case> randomCases() {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  const auto point = [&] { return glm::vec3(unit(random), unit(random), unit(random)); };
  std::vector<Case> cases;
  for (int i = 0; i < 500; ++i) {
    const glm::vec3 a = point();
    const glm::vec3 b = point();
    Case c{minimum(a, b), maximum(a, b), 3.0f * point() - 1.0f, {}};
    c.target = c.low + point() * (c.high - c.low);
    cases.push_back(c);
  }
  return cases;
}

bool isInside(const Case& c, const glm::vec3& value, float slack) {
  return clamped(value, c.low - slack, c.high + slack) == value;
}

/// Distance of `p` from the line through a and b.
float distanceFromLine(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b) {
  return glm::length(glm::cross(p - a, glm::normalize(b - a)));
}

TEST(TwinRectify, KeepsColorsInsideTheBoxExactly) {
  for (const Case& c : randomCases()) {
    for (const RectifyMethod method : kMethods) {
      const Rectified clipped = clip(method, c.target, c.history, c.low, c.high);
      EXPECT_EQ(clipped.value, c.target);
      EXPECT_EQ(clipped.amount, 0.0f);
    }
    EXPECT_EQ(clip(RectifyMethod::None, c.history, c.target, c.low, c.high).value, c.history);
  }
}

TEST(TwinRectify, BringsEverythingIntoTheBoxAndIsIdempotent) {
  constexpr float kRounding = 1e-6f; // a few roundings of values up to 3
  for (const Case& c : randomCases()) {
    for (const RectifyMethod method : kMethods) {
      const Rectified once = clip(method, c.history, c.target, c.low, c.high);
      EXPECT_TRUE(isInside(c, once.value, kRounding));
      const Rectified twice = clip(method, once.value, c.target, c.low, c.high);
      EXPECT_LE(glm::length(twice.value - once.value), kRounding);
      EXPECT_GE(once.amount, 0.0f);
      EXPECT_LE(once.amount, 1.0f);
    }
  }
}

TEST(TwinRectify, ClampFindsTheNearestPointOfTheBox) {
  for (const Case& c : randomCases()) {
    const float clampDistance =
        glm::distance(c.history, clip(RectifyMethod::Clamp, c.history, c.target, c.low, c.high).value);
    for (const RectifyMethod method : kMethods) {
      EXPECT_LE(clampDistance,
                glm::distance(c.history, clip(method, c.history, c.target, c.low, c.high).value) + 1e-6f);
    }
  }
}

TEST(TwinRectify, ClipsEndOnTheSurfaceAndOnTheLineToTheirTarget) {
  for (const Case& c : randomCases()) {
    if (isInside(c, c.history, 0.0f)) continue;
    const glm::vec3 center = 0.5f * (c.low + c.high);
    const glm::vec3 extent = 0.5f * (c.high - c.low);
    if (std::min({extent.x, extent.y, extent.z}) < 0.01f) continue; // |u| below is ill-conditioned
    for (const RectifyMethod method : {RectifyMethod::ClipToCenter, RectifyMethod::ClipToFiltered}) {
      const glm::vec3 aim = method == RectifyMethod::ClipToCenter ? center : c.target;
      const Rectified clipped = clip(method, c.history, c.target, c.low, c.high);
      const glm::vec3 u = glm::abs(clipped.value - center) / extent;
      EXPECT_NEAR(std::max({u.x, u.y, u.z}), 1.0f, 1e-4f); // 1e-6 of the color over the least extent
      EXPECT_LE(distanceFromLine(clipped.value, c.history, aim), 1e-6f);
      EXPECT_NEAR(glm::distance(c.history, clipped.value), clipped.amount * glm::distance(c.history, aim),
                  1e-5f);
    }
  }
}

// Techniques: 11.3.
TEST(TwinRectify, ClosedFormsInOneDimension) {
  const glm::vec3 low(1.0f, 0.0f, 0.0f);
  const glm::vec3 high(2.0f, 1.0f, 1.0f);
  const glm::vec3 history(5.5f, 0.5f, 0.5f); // 3.5 outside, 4 from the center
  const Rectified clamp = clip(RectifyMethod::Clamp, history, {}, low, high);
  EXPECT_EQ(clamp.value, glm::vec3(2.0f, 0.5f, 0.5f));
  EXPECT_EQ(clamp.amount, 0.875f);
  const Rectified center = clip(RectifyMethod::ClipToCenter, history, {}, low, high);
  EXPECT_NEAR(center.value.x, 2.0f, 1e-6f);
  EXPECT_NEAR(center.amount, 0.875f, 1e-6f);
  const Rectified filtered = clip(RectifyMethod::ClipToFiltered, history, {1.0f, 0.5f, 0.5f}, low, high);
  EXPECT_FLOAT_EQ(filtered.value.x, 2.0f);
  EXPECT_FLOAT_EQ(filtered.amount, 3.5f / 4.5f);
}

TEST(TwinRectify, ATargetOutsideIsBroughtIntoTheBoxFirst) {
  const glm::vec3 low(0.0f);
  const glm::vec3 high(1.0f);
  const Rectified clipped = clip(RectifyMethod::ClipToFiltered, glm::vec3(2.0f), glm::vec3(3.0f), low, high);
  EXPECT_EQ(clipped.value, high); // the clamped target: no extrapolation
  EXPECT_EQ(clipped.amount, 1.0f);
}

TEST(TwinRectify, AFlatBoxTakesAllHistoryToItself) {
  const glm::vec3 point(0.25f, 0.5f, 0.125f);
  for (const RectifyMethod method : kMethods) {
    const Rectified clipped = clip(method, {3.0f, 0.0f, 1.0f}, point, point, point);
    EXPECT_LE(glm::distance(clipped.value, point), 2e-8f); // the center's extent is 1e-8
    EXPECT_NEAR(clipped.amount, 1.0f, 1e-7f);
  }
}

TEST(TwinRectify, HistoryInTheBoxIsNotTakenThroughItsSpace) {
  const Inputs inputs = [] {
    Inputs made = test::constantInputs(3, 3, glm::vec3(0.0f));
    test::setHistory(made, glm::vec3(0.0f), 1.0f);
    return made;
  }();
  Neighborhood wide;
  wide.boxMin = glm::vec3(-1e5f);
  wide.boxMax = glm::vec3(1e5f);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> level(0.0f, 60000.0f);
  for (int i = 0; i < 100; ++i) {
    const glm::vec3 history(level(random), level(random), level(random));
    EXPECT_EQ(rectifyHistory(inputs, Settings{}, history, glm::vec3(1.0f), wide).value, history);
  }
}

/// Linear RGB boxes and the hull's method.
Settings hullSettings() {
  Settings settings;
  settings.space = {ColorSpace::Rgb, ToneSpace::Linear};
  settings.rectify.method = RectifyMethod::ClipToHull;
  return settings;
}

Inputs oneHistory() {
  Inputs made = test::constantInputs(3, 3, glm::vec3(0.0f));
  test::setHistory(made, glm::vec3(0.0f), 1.0f);
  return made;
}

// Techniques: 10.12.
TEST(TwinRectify, TheHullOfGraysHoldsNoColorWhateverTheirBox) {
  Neighborhood grays;
  for (int k = 0; k < 9; ++k) grays.samples[std::size_t(k)] = glm::vec3(0.125f * float(k));
  grays.boxMin = grays.min = glm::vec3(0.0f);
  grays.boxMax = grays.max = glm::vec3(1.0f);
  const glm::vec3 red(0.75f, 0.25f, 0.25f), target(0.5f);
  Settings settings = hullSettings();
  const Rectified hull = rectifyHistory(oneHistory(), settings, red, target, grays);
  EXPECT_EQ(hull.value, target);
  EXPECT_EQ(hull.amount, 1.0f);
  EXPECT_EQ(rectifyHistory(oneHistory(), settings, glm::vec3(0.625f), target, grays).value,
            glm::vec3(0.625f));
  settings.rectify.method = RectifyMethod::ClipToFiltered; // the box sees no color
  EXPECT_EQ(rectifyHistory(oneHistory(), settings, red, target, grays).value, red);
}

// More slabs leave less room: never less is taken away than by the box of the same samples.
TEST(TwinRectify, TheHullIsNeverWiderThanTheBoxOfItsSamples) {
  std::mt19937 random(12);
  std::uniform_real_distribution<float> level(0.0f, 1.0f), wide(0.0f, 2.0f);
  const auto color = [&](auto& spread) { return glm::vec3(spread(random), spread(random), spread(random)); };
  int tighter = 0;
  for (int i = 0; i < 500; ++i) {
    Neighborhood n;
    n.min = glm::vec3(1e9f);
    n.max = glm::vec3(-1e9f);
    glm::vec3 mean(0.0f);
    for (glm::vec3& sample : n.samples) {
      sample = color(level);
      mean += sample / 9.0f;
      n.min = glm::min(n.min, sample);
      n.max = glm::max(n.max, sample);
    }
    n.boxMin = n.min;
    n.boxMax = n.max;
    const glm::vec3 history = color(wide);
    Settings settings = hullSettings();
    const float hull = rectifyHistory(oneHistory(), settings, history, mean, n).amount;
    settings.rectify.method = RectifyMethod::ClipToFiltered;
    const float box = rectifyHistory(oneHistory(), settings, history, mean, n).amount;
    EXPECT_GE(hull, box);
    EXPECT_LE(hull, 1.0f);
    tighter += hull > box;
  }
  EXPECT_GT(tighter, 250);
}

// Techniques: 10.12.
TEST(TwinRectify, TheSlabsHoldEveryMixtureOfTheSamples) {
  std::mt19937 random(41);
  std::uniform_real_distribution<float> level(0.0f, 1.0f);
  for (int i = 0; i < 300; ++i) {
    Neighborhood n;
    glm::vec3 mixture(0.0f);
    float sum = 0.0f;
    for (glm::vec3& sample : n.samples) {
      sample = {level(random), level(random), level(random)};
      const float weight = level(random);
      mixture += weight * sample;
      sum += weight;
    }
    // A point of the convex hull lies in every slab, up to the roundings of its own making.
    EXPECT_LE(rectifyHistory(oneHistory(), hullSettings(), mixture / sum, n.samples[4], n).amount, 1e-5f);
  }
}

TEST(TwinRectify, TheSlabsAreTheBoxWhenItsCornersAreSamples) {
  Neighborhood n;
  for (int k = 0; k < 8; ++k)
    n.samples[std::size_t(k)] = {k & 1 ? 1.0f : 0.0f, k & 2 ? 1.0f : 0.0f, k & 4 ? 1.0f : 0.0f};
  n.samples[8] = glm::vec3(0.5f);
  n.boxMin = n.min = glm::vec3(0.0f);
  n.boxMax = n.max = glm::vec3(1.0f);
  Settings box = hullSettings();
  box.rectify.method = RectifyMethod::ClipToFiltered;
  std::mt19937 random(8);
  std::uniform_real_distribution<float> level(0.0f, 2.0f), inside(0.0f, 1.0f);
  for (int i = 0; i < 300; ++i) {
    const glm::vec3 history(level(random), level(random), level(random));
    const glm::vec3 target(inside(random), inside(random), inside(random));
    EXPECT_NEAR(rectifyHistory(oneHistory(), hullSettings(), history, target, n).amount,
                rectifyHistory(oneHistory(), box, history, target, n).amount, 1e-6f);
  }
}

} // namespace
} // namespace taa::twin
