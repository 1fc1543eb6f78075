// Rectification that looks at the nine samples and not at a box around them (manual 9.7, 11.8; invariants
// 34, 41).
#include "tests/support/frames/TwinInputs.h"

#include "core/taa/twin/Color.h"
#include "core/taa/twin/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

namespace taa::twin {
namespace {

constexpr auto kSpaces = {ColorSpace::Rgb, ColorSpace::YCoCg, ColorSpace::YCoCgLifting, ColorSpace::YCbCr,
                          ColorSpace::YCoCgAsPrinted};

Settings with(RectifyMethod method, ColorSpace color = ColorSpace::Rgb, ToneSpace tone = ToneSpace::Linear) {
  Settings settings;
  settings.space = {color, tone};
  settings.rectify.method = method;
  return settings;
}

Inputs oneHistory() {
  Inputs made = test::constantInputs(3, 3, glm::vec3(0.0f));
  test::setHistory(made, glm::vec3(0.0f), 1.0f);
  return made;
}

/// Nine colors, scene-linear, with the box around them.
Neighborhood around(const std::array<glm::vec3, 9>& colors, const SpaceSettings& space) {
  Neighborhood n;
  n.colors = colors;
  n.min = glm::vec3(1e9f);
  n.max = glm::vec3(-1e9f);
  for (std::size_t k = 0; k < colors.size(); ++k) {
    n.samples[k] = toBox(colors[k], space);
    n.min = minimum(n.min, n.samples[k]);
    n.max = maximum(n.max, n.samples[k]);
  }
  n.boxMin = n.min;
  n.boxMax = n.max;
  return n;
}

Rectified rectified(const Settings& settings, const std::array<glm::vec3, 9>& colors,
                    const glm::vec3& history, const glm::vec3& current = glm::vec3(0.5f)) {
  return rectifyHistory(oneHistory(), settings, history, current, around(colors, settings.space));
}

/// Random colors between 0 and `brightest`.
class Colors {
 public:
  explicit Colors(unsigned seed) : random_(seed) {}
  glm::vec3 one(float brightest = 1.0f) {
    return brightest * glm::vec3(level_(random_), level_(random_), level_(random_));
  }
  std::array<glm::vec3, 9> nine() {
    std::array<glm::vec3, 9> colors;
    for (glm::vec3& color : colors) color = one();
    return colors;
  }

 private:
  std::mt19937 random_;
  std::uniform_real_distribution<float> level_{0.0f, 1.0f};
};

/// How far a color is out of the box of others, in the axes of a space.
float outside(const glm::vec3& color, std::vector<glm::vec3> others, ColorSpace space) {
  glm::vec3 low(1e9f), high(-1e9f);
  for (const glm::vec3& other : others) {
    low = minimum(low, toBox(other, {space, ToneSpace::Linear}));
    high = maximum(high, toBox(other, {space, ToneSpace::Linear}));
  }
  const glm::vec3 boxed = toBox(color, {space, ToneSpace::Linear});
  float most = 0.0f;
  for (int i = 0; i < 3; ++i) most = std::max({most, low[i] - boxed[i], boxed[i] - high[i]});
  return most;
}

/// Grays from 0 to 1 in eighths.
std::array<glm::vec3, 9> grays() {
  std::array<glm::vec3, 9> colors;
  for (std::size_t k = 0; k < 9; ++k) colors[k] = glm::vec3(0.125f * static_cast<float>(k));
  return colors;
}

// Techniques: 9.1, 9.7.
TEST(RectifyBySamples, WhatOnlyOneOfTheTwoBoxesHoldsIsMoved) {
  const glm::vec3 red(0.75f, 0.25f, 0.25f), gray(0.625f);
  for (const ColorSpace space : kSpaces) {
    const Settings settings = with(RectifyMethod::ClipToBoth, space);
    EXPECT_EQ(rectified(settings, grays(), gray).value, gray) << "in both";
    const Rectified moved = rectified(settings, grays(), red); // no chroma: only the gray target is left
    EXPECT_NEAR(moved.amount, 1.0f, 1e-6f);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(moved.value[i], 0.5f, 1e-6f);
  }
  EXPECT_EQ(rectified(with(RectifyMethod::ClipToFiltered), grays(), red).value, red)
      << "the box of RGB alone";
}

TEST(RectifyBySamples, TheSixthSlabEndsTheWayWhereItStands) {
  std::array<glm::vec3, 9> colors = grays();
  colors[1] = {1.0f, 0.5f, 0.5f};            // Co = ¼
  colors[7] = {0.0f, 0.5f, 0.5f};            // Co = −¼
  const glm::vec3 history(1.0f, 0.5f, 0.0f); // Co = ½, half of which is too much
  for (const ColorSpace space : {ColorSpace::Rgb, ColorSpace::YCoCg, ColorSpace::YCoCgLifting}) {
    const Rectified moved = rectified(with(RectifyMethod::ClipToBoth, space), colors, history);
    EXPECT_EQ(moved.amount, 0.5f);
    EXPECT_EQ(moved.value, glm::vec3(0.75f, 0.5f, 0.25f));
  }
}

TEST(RectifyBySamples, BothBoxesAreTheSameWhicheverOfThemIsAskedFor) {
  Colors random(97);
  int moved = 0;
  for (int i = 0; i < 300; ++i) {
    const std::array<glm::vec3, 9> colors = random.nine();
    const glm::vec3 history = random.one(1.5f);
    const auto amount = [&](ColorSpace space) {
      return rectified(with(RectifyMethod::ClipToBoth, space), colors, history, colors[4]).amount;
    };
    const float rgb = amount(ColorSpace::Rgb);
    EXPECT_NEAR(amount(ColorSpace::YCoCg), rgb, 2e-5f);
    EXPECT_NEAR(amount(ColorSpace::YCoCgLifting), rgb, 2e-5f);
    moved += rgb > 0.0f;
  }
  EXPECT_GT(moved, 100) << "else the test shows nothing";
}

TEST(RectifyBySamples, EndsInBothBoxesAndKeepsWhatLiesInThem) {
  Colors random(7);
  for (const ColorSpace space : kSpaces) {
    const ColorSpace other = space == ColorSpace::Rgb ? ColorSpace::YCoCg : ColorSpace::Rgb;
    int kept = 0, moved = 0;
    for (int i = 0; i < 400; ++i) {
      const std::array<glm::vec3, 9> colors = random.nine();
      const glm::vec3 target = random.one(), history = random.one(1.2f);
      std::vector<glm::vec3> lockState(colors.begin(), colors.end());
      lockState.push_back(target); // the slabs are opened for it
      const Rectified result = rectified(with(RectifyMethod::ClipToBoth, space), colors, history, target);
      EXPECT_LE(outside(result.value, lockState, space), 1e-5f);
      EXPECT_LE(outside(result.value, lockState, other), 1e-5f);
      const float before = std::max(outside(history, lockState, space), outside(history, lockState, other));
      EXPECT_TRUE(result.moved || before <= 1e-5f);
      EXPECT_TRUE(result.amount <= 1e-5f || before > 0.0f);
      moved += result.moved;
      kept += before == 0.0f;
    }
    EXPECT_GT(kept, 20) << "else the test shows nothing";
    EXPECT_GT(moved, 20);
  }
}

// Invariant 41: directions that contain one another.
TEST(RectifyBySamples, SixSlabsStandBetweenTheBoxAndTheHull) {
  Colors random(41);
  int tighter = 0, looser = 0;
  for (int i = 0; i < 500; ++i) {
    const std::array<glm::vec3, 9> colors = random.nine();
    const glm::vec3 history = random.one(2.0f);
    const auto amount = [&](RectifyMethod method) {
      return rectified(with(method, ColorSpace::YCoCg), colors, history, colors[4]).amount;
    };
    const float box = amount(RectifyMethod::ClipToFiltered), both = amount(RectifyMethod::ClipToBoth),
                hull = amount(RectifyMethod::ClipToHull);
    EXPECT_GE(hull, both);
    EXPECT_GE(both, box);
    tighter += both > box;
    looser += hull > both;
  }
  EXPECT_GT(tighter, 50);
  EXPECT_GT(looser, 50);
}

// Techniques: 11.8.
TEST(RectifyBySamples, SelectTakesTheNearestSampleBitForBit) {
  Colors random(118);
  for (const ToneSpace tone : {ToneSpace::Linear, ToneSpace::ReinhardLuma})
    for (int i = 0; i < 200; ++i) {
      const SpaceSettings space{ColorSpace::YCoCg, tone};
      const std::array<glm::vec3, 9> colors = random.nine();
      const glm::vec3 history = random.one(1.5f);
      const Rectified result = rectified(with(RectifyMethod::Select, space.color, tone), colors, history);
      EXPECT_EQ(std::ranges::count(colors, result.value), 1);
      EXPECT_EQ(result.amount, 1.0f);
      const auto distance = [&](const glm::vec3& color) {
        const glm::vec3 way = toBox(color, space) - toBox(history, space);
        return (way.x * way.x + way.y * way.y) + way.z * way.z;
      };
      for (const glm::vec3& color : colors) EXPECT_LE(distance(result.value), distance(color));
    }
}

TEST(RectifyBySamples, OfEquallyNearSamplesTheCenterThenTheFirstIsTaken) {
  std::array<glm::vec3, 9> colors;
  colors.fill(glm::vec3(4.0f));
  colors[1] = colors[4] = glm::vec3(0.75f);
  colors[0] = glm::vec3(0.25f);
  const Settings settings = with(RectifyMethod::Select);
  EXPECT_EQ(rectified(settings, colors, glm::vec3(0.5f)).value, glm::vec3(0.75f))
      << "the center, not the first";
  colors[4] = glm::vec3(4.0f);
  EXPECT_EQ(rectified(settings, colors, glm::vec3(0.5f)).value, glm::vec3(0.25f)) << "the first";
}

// Techniques: 17.6.
TEST(RectifyBySamples, SelectReplacesHistoryInsideTheBoxButKeepsASample) {
  const Settings settings = with(RectifyMethod::Select);
  EXPECT_EQ(rectified(settings, grays(), glm::vec3(0.3f)).value, glm::vec3(0.25f));
  const Rectified same = rectified(settings, grays(), glm::vec3(0.25f));
  EXPECT_EQ(same.value, glm::vec3(0.25f));
  EXPECT_EQ(same.amount, 0.0f);
  EXPECT_FALSE(same.moved);
}

TEST(RectifyBySamples, SelectIsAppliedInPartAsOtherMethodsAre) {
  Settings settings = with(RectifyMethod::Select);
  settings.rectify.relaxAtRest = Switch::On;
  settings.rectify.minStrength = 0.5f;
  const Rectified half = rectified(settings, grays(), glm::vec3(2.0f)); // at rest
  EXPECT_EQ(half.value, glm::vec3(1.5f));
  EXPECT_EQ(half.amount, 0.5f);
  Inputs first = oneHistory();
  first.historyColor = {};
  EXPECT_EQ(rectifyHistory(first, settings, glm::vec3(2.0f), glm::vec3(0.5f), {}).value, glm::vec3(2.0f));
}

// Invariant 34.
TEST(RectifyBySamples, AConstantTakesAllHistoryToItself) {
  for (const float level : {0.0f, 1e-4f, 1.0f, 1000.0f, 65504.0f}) {
    std::array<glm::vec3, 9> colors;
    colors.fill(glm::vec3(level));
    for (const RectifyMethod method : {RectifyMethod::ClipToBoth, RectifyMethod::Select})
      for (const ColorSpace space : {ColorSpace::Rgb, ColorSpace::YCoCg, ColorSpace::YCoCgLifting}) {
        const Settings settings = with(method, space);
        EXPECT_EQ(rectified(settings, colors, glm::vec3(3.0f, 0.0f, 1.0f), glm::vec3(level)).value,
                  glm::vec3(level));
      }
  }
}

} // namespace
} // namespace taa::twin
