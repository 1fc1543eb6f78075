// What is known of the costs of stages, from times made up by hand.
#include "core/measure/StageCosts.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

using namespace taa;

namespace {

constexpr std::array kStages{Stage::Inputs, Stage::Neighborhood, Stage::Blend};
constexpr std::size_t kRounds = 15;

/// Programs that take 1, then what the three stages add, on a machine that is `slow(round)` times slower.
template <typename Slow, typename Noise>
std::vector<StageCost> costsOf(const std::array<double, 3>& stages, Slow slow, Noise noise) {
  std::vector<RoundTimes> times(kStages.size() + 1, RoundTimes(kRounds));
  for (std::size_t round = 0; round < kRounds; ++round) {
    double time = 1.0;
    for (std::size_t program = 0; program < times.size(); ++program) {
      if (program > 0) time += stages.at(program - 1);
      times[program][round] = slow(round) * time + noise(program, round);
    }
  }
  return stageCosts(kStages, times);
}

constexpr auto kSteady = [](std::size_t) { return 1.0; };
constexpr auto kQuiet = [](std::size_t, std::size_t) { return 0.0; };

} // namespace

TEST(MeasuredMs, HasTheRangeOfTheSignTest) {
  std::vector<double> values;
  for (int value = 1; value <= 15; ++value) values.push_back(value);
  // Of 15 coins three or fewer fall on one side with 576 of 32768; four or fewer with 1941.
  const MeasuredMs fifteen = measured(values);
  EXPECT_EQ(fifteen.median, 8.0);
  EXPECT_EQ(fifteen.low, 4.0);
  EXPECT_EQ(fifteen.high, 12.0);
  EXPECT_EQ(fifteen.spread(), 4.0);
  values.resize(6); // all on one side: 1 of 64
  EXPECT_EQ(measured(values).low, 1.0);
  EXPECT_EQ(measured(values).high, 6.0);
  EXPECT_EQ(measured(values).median, 3.5);
}

TEST(MeasuredMs, OfTooFewKnowsNothing) {
  const MeasuredMs five = measured({1.0, 1.0, 1.0, 1.0, 1.0});
  EXPECT_EQ(five.median, 1.0);
  EXPECT_EQ(five.low, -std::numeric_limits<double>::infinity());
  EXPECT_EQ((StageCost{Stage::Blend, five}.verdict()), CostVerdict::Noise);
}

TEST(MeasuredMs, IsNotWidenedByOutliers) {
  std::vector<double> values(15, 2.0);
  values[3] = 400.0;
  values[7] = -90.0;
  EXPECT_EQ(measured(values).low, 2.0);
  EXPECT_EQ(measured(values).high, 2.0);
}

TEST(StageCosts, AreClearWhereTheyStandOut) {
  const std::vector<StageCost> costs =
      costsOf({0.5, 2.0, 0.25}, kSteady, [](std::size_t program, std::size_t round) {
        return 0.03125 * static_cast<double>((round * 7 + program * 3) % 5); // 0 to 0.125
      });
  ASSERT_EQ(costs.size(), 3u);
  EXPECT_EQ(costs[1].stage, Stage::Neighborhood);
  EXPECT_NEAR(costs[1].ms.median, 2.0, 0.125);
  for (const StageCost& cost : costs) {
    EXPECT_EQ(cost.verdict(), CostVerdict::Clear);
    EXPECT_EQ(verdictWords(cost), "");
    EXPECT_LE(cost.ms.spread(), 0.25);
  }
}

TEST(StageCosts, AddUpToWhatTheLastProgramTakesMore) {
  double sum = 0.0;
  for (const StageCost& cost : costsOf({0.5, 2.0, 0.25}, kSteady, kQuiet)) sum += cost.ms.median;
  EXPECT_EQ(sum, 2.75);
}

TEST(StageCosts, ArePairedSoThatASlowMachineFallsOut) {
  // Ten times slower in the course of the rounds: unpaired, the ranges of two programs would be one.
  const auto slower = [](std::size_t round) { return 1.0 + 0.6 * static_cast<double>(round); };
  for (const StageCost& cost : costsOf({0.01, 0.02, 0.01}, slower, kQuiet))
    EXPECT_EQ(cost.verdict(), CostVerdict::Clear) << cost.ms.low;
}

TEST(StageCosts, ThatAreNotAboveTheNoiseAreSaidToBe) {
  const auto noise = [](std::size_t program, std::size_t round) {
    return (round + program) % 2 == 0 ? 0.5 : 0.0; // differences ± 0.5
  };
  for (const StageCost& cost : costsOf({0.125, 0.125, 0.0}, kSteady, noise)) {
    EXPECT_EQ(cost.verdict(), CostVerdict::Noise);
    EXPECT_LT(cost.ms.low, 0.0);
    EXPECT_GT(cost.ms.high, 0.0);
  }
  const StageCost cost{Stage::Blend, {0.25, -0.125, 0.65}};
  EXPECT_EQ(verdictWords(cost), "not above the noise, ± 0.400 ms");
  const StageCost skew{Stage::Blend, {4.0, 0.5, 11.0}};
  EXPECT_EQ(skew.verdict(), CostVerdict::Noise) << "4 ± 7 says nothing, though its range is above 0";
}

TEST(StageCosts, BelowZeroAreNoCosts) {
  const std::vector<StageCost> costs = costsOf({0.5, 0.5, -0.25}, kSteady, kQuiet);
  EXPECT_EQ(costs[2].verdict(), CostVerdict::Negative);
  EXPECT_EQ(costs[2].ms.median, -0.25);
  EXPECT_TRUE(verdictWords(costs[2]).starts_with("below 0"));
}

TEST(StageCosts, CallNoiseACostInFourOfAHundredAtMost) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  int claims = 0, cases = 0;
  for (int run = 0; run < 1000; ++run)
    for (const StageCost& cost : costsOf({0.0, 0.0, 0.0}, kSteady, [&](std::size_t, std::size_t) {
           const double value = normal(random);
           return value * value * value; // far outliers
         })) {
      claims += cost.verdict() != CostVerdict::Noise;
      ++cases;
    }
  EXPECT_LE(claims, cases * 45 / 1000) << "4 of 100, and what 3,000 draws may be off";
}
