// When the doctor calls a region's motion wrong, right or undecided: on evidence made by hand.
#include "core/doctor/motion/MotionDecision.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace taa::doctor {
namespace {

using Indices = std::vector<std::size_t>;

const std::vector<MotionTrial>& trials() {
  static const std::vector<MotionTrial> kTrials = {
      {MotionKind::AsGiven}, {MotionKind::Resting}, {MotionKind::MirroredY}, {MotionKind::Opposite}};
  return kTrials;
}

/// Of 1000 pixels: what is left of each as given and by the trial.
TrialEvidence evidenceOf(double given, double tried, double wonShare = 1.0) {
  TrialEvidence out;
  out.pixels = 1000;
  out.given = 1000.0 * given;
  out.tried = 1000.0 * tried;
  out.cells = 20;
  out.cellsWon = static_cast<std::size_t>(20.0 * wonShare);
  out.pairs = out.pairsWon = 5;
  return out;
}

/// A textured region that moves, whose motion fits.
RegionEvidence region();

/// One that a search finds elsewhere, with its silhouette: of 1000 of its 2000 pixels.
RegionEvidence foundRegion() {
  RegionEvidence out = region();
  out.found = evidenceOf(0.06, 0.02);
  out.silhouetteGiven = 100;
  out.silhouetteFound = 10;
  return out;
}

RegionEvidence region() {
  RegionEvidence out;
  out.pixels = 2000;
  out.textured = 1000;
  out.pairs = 5;
  out.givenPx = 4000.0;
  out.trials = {TrialEvidence(), evidenceOf(0.02, 0.05), evidenceOf(0.02, 0.06), evidenceOf(0.02, 0.08)};
  return out;
}

} // namespace

TEST(MotionDecision, IsRightWhereOthersLeaveMore) {
  EXPECT_EQ(decideMotion(region(), trials()).verdict, MotionVerdict::Right);
}

TEST(MotionDecision, IsWrongWhereATrialLeavesMuchLess) {
  RegionEvidence wrong = region();
  wrong.trials[2] = evidenceOf(0.06, 0.02);
  const MotionDecision decision = decideMotion(wrong, trials());
  EXPECT_EQ(decision.verdict, MotionVerdict::Wrong);
  EXPECT_EQ(decision.explanations, Indices{2});
}

TEST(MotionDecision, NamesAllThatFitAsWell) {
  RegionEvidence wrong = region();
  wrong.trials[2] = evidenceOf(0.06, 0.02);
  wrong.trials[3] = evidenceOf(0.06, 0.0219); // gains 0.0381 of 0.04: 95.25 %
  EXPECT_EQ(decideMotion(wrong, trials()).explanations, (Indices{2, 3}));
  wrong.trials[3] = evidenceOf(0.06, 0.0221); // 94.75 %
  EXPECT_EQ(decideMotion(wrong, trials()).explanations, Indices{2});
}

// Rest leaves less, though in half of the squares: then what leaves more is no explanation either.
TEST(MotionDecision, TellsNothingWhereSomethingUnclearLeavesLess) {
  RegionEvidence wrong = region();
  wrong.trials[1] = evidenceOf(0.06, 0.005, 0.5);
  wrong.trials[2] = evidenceOf(0.06, 0.02);
  EXPECT_EQ(decideMotion(wrong, trials()).verdict, MotionVerdict::Doubtful);
}

TEST(MotionDecision, RestsOnMostSquaresAndOnEnoughOfAll) {
  for (const auto spoil :
       {+[](TrialEvidence& trial) { trial.cellsWon = 15; }, +[](TrialEvidence& trial) { trial.pairsWon = 3; },
        +[](TrialEvidence& trial) { trial.cells = trial.cellsWon = 4; },
        +[](TrialEvidence& trial) { trial.pairs = trial.pairsWon = 2; },
        +[](TrialEvidence& trial) { trial.pixels = 149; },
        +[](TrialEvidence& trial) { trial.tried = trial.given / 1.49; },
        +[](TrialEvidence& trial) { trial.given = 3.9, trial.tried = 0.0; }}) {
    RegionEvidence evidence = region();
    evidence.trials[2] = evidenceOf(0.06, 0.02);
    spoil(evidence.trials[2]);
    EXPECT_NE(decideMotion(evidence, trials()).verdict, MotionVerdict::Wrong);
  }
}

TEST(MotionDecision, BelievesDepthAndCamerasMoreThanPixels) {
  RegionEvidence confirmed = region();
  confirmed.cameraKnown = confirmed.ofCamera = confirmed.pixels;
  confirmed.cameraPx = 1.0 * static_cast<double>(confirmed.pixels);
  confirmed.trials[2] = evidenceOf(0.06, 0.02);
  EXPECT_NE(decideMotion(confirmed, trials()).verdict, MotionVerdict::Wrong);
  // What rests on the screen lies over what is behind it.
  confirmed.trials[1] = evidenceOf(0.06, 0.019);
  EXPECT_EQ(decideMotion(confirmed, trials()).explanations, Indices{1});
  confirmed.trials[1] = evidenceOf(0.06, 0.021); // less than three times better
  EXPECT_NE(decideMotion(confirmed, trials()).verdict, MotionVerdict::Wrong);
}

TEST(MotionDecision, TakesWhatWasSearchedForOnlyInDetailedRegions) {
  RegionEvidence found = foundRegion();
  const MotionDecision decision = decideMotion(found, trials());
  EXPECT_EQ(decision.verdict, MotionVerdict::Wrong);
  EXPECT_TRUE(decision.explanations.empty());
  found.textured = 599; // of 2000: as much as a shadow's edge has
  EXPECT_NE(decideMotion(found, trials()).verdict, MotionVerdict::Wrong);
}

// A light or a shadow that moves over a region is found in a part of it.
TEST(MotionDecision, TakesWhatWasSearchedForOnlyInMostOfARegion) {
  RegionEvidence found = foundRegion();
  found.pixels = 4500;
  found.textured = 2000;
  EXPECT_EQ(decideMotion(found, trials()).verdict, MotionVerdict::Wrong);
  found.textured = 2001;
  EXPECT_NE(decideMotion(found, trials()).verdict, MotionVerdict::Wrong);
}

// A light or a shadow takes no silhouette with it.
TEST(MotionDecision, TakesWhatWasSearchedForOnlyWhereTheRimMovesToo) {
  RegionEvidence found = foundRegion();
  found.silhouetteFound = 75; // of 100
  EXPECT_EQ(decideMotion(found, trials()).verdict, MotionVerdict::Wrong);
  found.silhouetteFound = 76;
  EXPECT_NE(decideMotion(found, trials()).verdict, MotionVerdict::Wrong);
  found = foundRegion();
  found.silhouetteGiven = 23;
  found.silhouetteFound = 0;
  EXPECT_NE(decideMotion(found, trials()).verdict, MotionVerdict::Wrong);
}

TEST(MotionDecision, CountsWhatATrialSaysNothingOfLikeTheRest) {
  TrialEvidence half = evidenceOf(0.06, 0.02); // 40 less in 1000 pixels
  half.asked = 2000;
  half.said = 1000;
  EXPECT_NEAR(half.gain(), 80.0, 1e-9);
  half.said = 2000;
  EXPECT_NEAR(half.gain(), 40.0, 1e-9);
}

TEST(MotionDecision, SaysWhyItDoesNotDecide) {
  RegionEvidence small = region();
  small.pixels = 149;
  EXPECT_EQ(decideMotion(small, trials()).verdict, MotionVerdict::TooSmall);
  RegionEvidence seldom = region();
  seldom.pairs = 2;
  EXPECT_EQ(decideMotion(seldom, trials()).verdict, MotionVerdict::TooSmall);
  RegionEvidence plain = region();
  plain.textured = 39;
  EXPECT_EQ(decideMotion(plain, trials()).verdict, MotionVerdict::NoTexture);
  RegionEvidence still = region();
  still.trials.assign(trials().size(), TrialEvidence());
  EXPECT_EQ(decideMotion(still, trials()).verdict, MotionVerdict::Still);
  RegionEvidence lit = region();
  for (TrialEvidence& trial : lit.trials) trial = evidenceOf(0.05, 0.055);
  EXPECT_EQ(decideMotion(lit, trials()).verdict, MotionVerdict::Contradicted);
}

} // namespace taa::doctor
