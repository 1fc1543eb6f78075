// What is concluded from the luma that trials of jitter leave, on numbers whose shares are plain.
#include "core/doctor/jitter/JitterFit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace taa::doctor {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// As stated, none, and a third one: what the pictures hold is three times what is stated.
const std::vector<JitterTrial>& threeTrials() {
  static const std::vector<JitterTrial> kTrials = {
      {}, {JitterKind::NotApplied}, {JitterKind::Scaled, glm::vec2(3.0f)}};
  return kTrials;
}

/// A shift of a quarter of a pixel is stated, of which the third trial makes three; measured is `shiftPx`.
JitterFit fitOf(const std::vector<TrialLuma>& pairs, float shiftPx) {
  JitterEvidence evidence;
  evidence.world = pairs;
  evidence.stated = {{0, glm::vec2(0.25f, 0.0f)}, {1, glm::vec2(0.0f)}};
  evidence.shifts = {{1, {shiftPx, 0.0f}}};
  return jitterFit(evidence, threeTrials());
}

JitterFit fitOfEight(const TrialLuma& each, float shiftPx = 0.5625f) {
  return fitOf(std::vector<TrialLuma>(8, each), shiftPx);
}

} // namespace

TEST(JitterFit, CountsPairsInWhichATrialShiftsOtherwise) {
  // Of three pairs the first has no such trial, and in the second both shift alike.
  const TrialFit fit = fitOf({{1.0, kUnknown}, {1.0, 1.0}, {1.0, 0.25}}, 1, 0);
  EXPECT_EQ(fit.pairs, 1);
  EXPECT_EQ(fit.won, 1);
  EXPECT_EQ(fit.stated, 1.0);
  EXPECT_EQ(fit.tried, 0.25);
  EXPECT_TRUE(std::isinf(fit.share())); // too few
}

TEST(JitterFit, ConfirmsWhatIsStatedWhereNothingFitsBetter) {
  EXPECT_TRUE(fitOfEight({1.0, 1.5, 2.0}).isConfirmed());
  EXPECT_FALSE(fitOfEight({1.0, 1.5, 2.0}).isContradicted());
  EXPECT_FALSE(fitOfEight({1.0, 1.5, 0.9}).isConfirmed());
  EXPECT_FALSE(fitOfEight({1.0, 1.5, 0.9}).isContradicted()); // nor is anything clear
}

// What sways is read softer, and shorter jitter is: by chance that fits a little better in some pairs.
TEST(JitterFit, ConfirmsWhereAnotherLengthFitsBetterInSomePairs) {
  const auto fitOfHalves = [](double best, double other, float shiftPx) {
    std::vector<TrialLuma> pairs(4, {1.0, 1.5, best});
    pairs.insert(pairs.end(), 4, {1.0, 1.5, other});
    return fitOf(pairs, shiftPx);
  };
  EXPECT_LT(fitOfHalves(0.9, 1.02, 0.25f).trials[2].share(), 0.98);
  EXPECT_TRUE(fitOfHalves(0.9, 1.02, 0.25f).isConfirmed());
  EXPECT_FALSE(fitOfHalves(0.9, 0.99, 0.25f).isConfirmed()) << "in all pairs";
  EXPECT_FALSE(fitOfHalves(0.9, 1.02, 0.75f).isConfirmed()) << "shifts are those of the other length";
}

TEST(JitterFit, IsMeasuredWhereShiftsAreThoseStatedAndNoOthers) {
  JitterFit fit;
  fit.missPx = {0.01, 0.3, 0.1};
  EXPECT_TRUE(fit.isMeasured());
  fit.missPx[2] = 0.09;
  EXPECT_FALSE(fit.isMeasured()) << "another is as near";
  fit.missPx = {0.021, 0.3, 0.2};
  EXPECT_FALSE(fit.isMeasured());
}

TEST(JitterFit, ContradictsWhatIsStatedWhereMeasuredShiftsSayTheSame) {
  const JitterFit fit = fitOfEight({1.0, 1.5, 0.9}, 0.75f);
  EXPECT_EQ(fit.missPx, (std::vector<double>{0.5, 0.75, 0.0}));
  EXPECT_TRUE(fit.isContradicted());
  EXPECT_FALSE(fitOfEight({1.0, 1.5, 0.99}, 0.75f).isContradicted());
}

TEST(JitterFit, ContradictsWhatIsStatedWhereATrialFitsBetterInNearlyAllPairs) {
  const JitterFit fit = fitOfEight({1.0, 0.8, 0.4});
  EXPECT_TRUE(fit.isContradicted());
  EXPECT_EQ(fit.best, 2u);
  EXPECT_EQ(fit.statedLuma, 1.0);
  EXPECT_TRUE(fit.rivals().empty());
  // In two of eight it does not, though it leaves less in all of them together.
  std::vector<TrialLuma> pairs(8, {1.0, 2.0, 0.25});
  pairs[0][2] = pairs[1][2] = 1.5;
  EXPECT_FALSE(fitOf(pairs, 0.5625f).isContradicted());
}

TEST(JitterFit, ContradictsNothingWithoutShiftsThatAgree) {
  EXPECT_FALSE(fitOfEight({1.0, 0.8, 0.4}, 0.25f).isContradicted()); // as stated
  EXPECT_FALSE(fitOfEight({1.0, 0.8, 0.4}, 1.25f).isContradicted()); // as neither
}

TEST(JitterFit, HasRivalsThatLeaveHardlyMore) {
  EXPECT_EQ(fitOfEight({1.0, 0.41, 0.4}).rivals(), std::vector<std::size_t>{1});
}

TEST(JitterFit, TellsASkyThatRests) {
  JitterEvidence evidence;
  EXPECT_FALSE(isSkyResting(evidence, 0));
  evidence.sky.assign(8, {1.0, 0.25, 2.0});
  EXPECT_EQ(isSkyResting(evidence, 0), true);
  evidence.sky.assign(8, {1.0, 0.5, 2.0});
  EXPECT_EQ(isSkyResting(evidence, 0), false);
  EXPECT_EQ(isSkyResting(evidence, 2), true); // beside what the third trial makes of it
}

// What says two things is asked only where nothing that says one is clear, and then both luma and shifts have
// to say so.
TEST(JitterFit, SaysTwoThingsWhereOneIsNotEnough) {
  JitterEvidence evidence;
  evidence.stated = {{0, glm::vec2(0.0f)}, {1, glm::vec2(0.25f, 0.0f)}, {2, glm::vec2(0.0f, 0.5f)}};
  const std::vector<JitterTrial> trials = {
      {}, {JitterKind::NotApplied}, {JitterKind::Opposite, glm::vec2(1.0f), JitterKind::FrameLate}};
  // Of frame 1 pictures hold (0, -0.5), of frame 0 (-0.25, 0): the second trial's.
  evidence.shifts = {{1, {-0.25f, 0.5f}}};
  evidence.world.assign(8, {1.0, 1.5, 0.25});
  const JitterFit both = jitterFit(evidence, trials);
  EXPECT_EQ(both.best, 2u);
  EXPECT_TRUE(both.isContradicted());
  evidence.world.assign(8, {1.0, 0.5, 0.25});
  evidence.shifts = {{1, {0.0f, 0.0f}}}; // none at all
  EXPECT_EQ(jitterFit(evidence, trials).best, 1u);
  evidence.world.assign(8, {1.0, 1.5, 0.25});
  EXPECT_NE(jitterFit(evidence, trials).best, 2u) << "shifts say something else";
}

} // namespace taa::doctor
