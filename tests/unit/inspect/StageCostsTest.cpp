// What is known of the costs of stages, from times made up by hand, and what they are measured against.
#include "core/measure/StageCosts.h"

#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <span>

using namespace taa;

namespace {

constexpr std::size_t kRounds = 15;

/// Resolves that take 1, and 1 and what the stage adds, on a machine that is `slow(round)` times slower.
template <typename Slow, typename Noise>
StageCost costOf(double stage, Slow slow, Noise noise) {
  PairedTimes times;
  for (std::size_t round = 0; round < kRounds; ++round) {
    times.own.push_back(slow(round) * (1.0 + stage) + noise(0, round));
    times.base.push_back(slow(round) + noise(1, round));
  }
  return {Stage::Neighborhood, timeDifference(times)};
}

constexpr auto kSteady = [](std::size_t) { return 1.0; };
constexpr auto kQuiet = [](std::size_t, std::size_t) { return 0.0; };

} // namespace

TEST(StageCosts, AreClearWhereTheyStandOut) {
  for (const double added : {0.5, 2.0, 0.25}) {
    const StageCost cost = costOf(added, kSteady, [](std::size_t side, std::size_t round) {
      return 0.03125 * static_cast<double>((round * 7 + side * 3) % 5); // 0 to 0.125
    });
    EXPECT_NEAR(cost.ms.median, added, 0.125);
    EXPECT_EQ(cost.verdict(), CostVerdict::Clear);
    EXPECT_EQ(verdictWords(cost), "");
    EXPECT_LE(cost.ms.spread(), 0.25);
  }
}

TEST(StageCosts, ArePairedSoThatASlowMachineFallsOut) {
  // Ten times slower in the course of the rounds: unpaired, the ranges of the two would be one.
  const auto slower = [](std::size_t round) { return 1.0 + 0.6 * static_cast<double>(round); };
  for (const double added : {0.01, 0.02}) {
    const StageCost cost = costOf(added, slower, kQuiet);
    EXPECT_EQ(cost.verdict(), CostVerdict::Clear) << cost.ms.low;
  }
}

TEST(StageCosts, ThatAreNotAboveTheNoiseAreSaidToBe) {
  const auto noise = [](std::size_t side, std::size_t round) {
    return (round + side) % 2 == 0 ? 0.5 : 0.0; // differences ± 0.5
  };
  for (const double added : {0.125, 0.0}) {
    const StageCost cost = costOf(added, kSteady, noise);
    EXPECT_EQ(cost.verdict(), CostVerdict::Noise);
    EXPECT_LT(cost.ms.low, 0.0);
    EXPECT_GT(cost.ms.high, 0.0);
  }
  const StageCost cost{Stage::Blend, {0.25, -0.125, 0.65}};
  EXPECT_EQ(verdictWords(cost), "not above the noise, ± 0.400 ms");
  const StageCost skew{Stage::Blend, {4.0, 0.5, 11.0}};
  EXPECT_EQ(skew.verdict(), CostVerdict::Noise) << "4 ± 7 says nothing, though its range is above 0";
  EXPECT_EQ((StageCost{Stage::Blend, measured({1.0, 1.0, 1.0, 1.0, 1.0})}.verdict()), CostVerdict::Noise)
      << "of too few";
}

TEST(StageCosts, BelowZeroAreNoCosts) {
  const StageCost cost = costOf(-0.25, kSteady, kQuiet);
  EXPECT_EQ(cost.verdict(), CostVerdict::Negative);
  EXPECT_EQ(cost.ms.median, -0.25);
  EXPECT_TRUE(verdictWords(cost).starts_with("below 0"));
}

TEST(StageCosts, OfTheCheapestSettingsAreNothing) {
  const StageCost cost{.stage = Stage::Blend, .ms = {}, .isCheapest = true};
  EXPECT_EQ(cost.verdict(), CostVerdict::Cheapest);
  EXPECT_NE(verdictWords(cost), "");
}

TEST(StageCosts, CallNoiseACostInFourOfAHundredAtMost) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  int claims = 0, cases = 0;
  for (; cases < 3000; ++cases) {
    const StageCost cost = costOf(0.0, kSteady, [&](std::size_t, std::size_t) {
      const double value = normal(random);
      return value * value * value; // far outliers
    });
    claims += cost.verdict() != CostVerdict::Noise;
  }
  EXPECT_LE(claims, cases * 45 / 1000) << "4 of 100, and what 3,000 draws may be off";
}

// Else there would be a row that says nothing, or settings that no row speaks of.
TEST(StageCosts, AreThoseOfAllStagesWhoseSettingsTheResolveCarriesOut) {
  for (const StageInfo& stage : kResolveStages) {
    const bool hasRows = std::ranges::any_of(parameters(), [&](const Parameter& row) {
      return row.stage == stage.stage && row.effect != Effect::Inputs && row.effect != Effect::Whole;
    });
    EXPECT_EQ(std::ranges::find(kCostStages, stage.stage, &StageInfo::stage) != kCostStages.end(), hasRows)
        << stage.id;
  }
}

TEST(StageCosts, AreAgainstTheSettingsThatMinimalHasForTheStage) {
  const Settings minimal = preset("minimal").settings;
  for (const Preset& own : builtinPresets())
    for (const StageInfo& stage : kCostStages) {
      const Settings base = withCheapest(own.settings, std::span(&stage, 1));
      for (const Parameter& row : parameters())
        ASSERT_EQ(row.get(base), row.get(row.stage == stage.stage ? minimal : own.settings))
            << own.id << ": " << stage.id << ", " << row.path;
      ASSERT_TRUE(sameInputs(base, own.settings)) << own.id << ": " << stage.id;
    }
  EXPECT_TRUE(withCheapest(minimal, kCostStages) == minimal);
}
