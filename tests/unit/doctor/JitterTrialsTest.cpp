// What pictures hold under each explanation of jitter, and how far measured shifts are from it.
#include "core/doctor/jitter/JitterTrials.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

namespace taa::doctor {
namespace {

const std::map<int, glm::vec2>& stated() {
  static const std::map<int, glm::vec2> kStated = {
      {0, {0.25f, -0.5f}}, {1, {-0.125f, 0.375f}}, {2, {0.5f, 0.0f}}};
  return kStated;
}

glm::vec2 shown(JitterKind kind, int frame, const glm::vec2& factor = glm::vec2(1.0f)) {
  return trueJitter({kind, factor}, stated(), frame).value_or(glm::vec2(99.0f));
}

} // namespace

TEST(JitterTrials, ChangeTheStatedJitter) {
  EXPECT_EQ(shown(JitterKind::AsStated, 1), glm::vec2(-0.125f, 0.375f));
  EXPECT_EQ(shown(JitterKind::NotApplied, 1), glm::vec2(0.0f));
  EXPECT_EQ(shown(JitterKind::MirroredX, 1), glm::vec2(0.125f, 0.375f));
  EXPECT_EQ(shown(JitterKind::MirroredY, 1), glm::vec2(-0.125f, -0.375f));
  EXPECT_EQ(shown(JitterKind::Opposite, 1), glm::vec2(0.125f, -0.375f));
  EXPECT_EQ(shown(JitterKind::SwappedAxes, 1), glm::vec2(0.375f, -0.125f));
  EXPECT_EQ(shown(JitterKind::Scaled, 1, glm::vec2(2.0f)), glm::vec2(-0.25f, 0.75f));
  EXPECT_EQ(shown(JitterKind::OtherUnit, 1, {80.0f, -48.0f}), glm::vec2(-10.0f, -18.0f));
}

TEST(JitterTrials, TakeTheJitterOfOtherFrames) {
  EXPECT_EQ(shown(JitterKind::FrameLate, 1), glm::vec2(0.5f, 0.0f));
  EXPECT_EQ(shown(JitterKind::FrameEarly, 1), glm::vec2(0.25f, -0.5f));
  EXPECT_FALSE(trueJitter({JitterKind::FrameLate}, stated(), 2));
  EXPECT_FALSE(trueJitter({JitterKind::FrameEarly}, stated(), 0));
}

TEST(JitterTrials, SayTwoThingsAtOnce) {
  const JitterTrial late{JitterKind::Opposite, glm::vec2(1.0f), JitterKind::FrameLate};
  EXPECT_EQ(trueJitter(late, stated(), 1), glm::vec2(-0.5f, 0.0f));
  EXPECT_EQ(jitterTrialId(late), "opposite+frameLate");
  EXPECT_FALSE(trueJitter(late, stated(), 2));
  const auto trials = jitterTrials({160, 96});
  const auto pair = std::ranges::find(trials, true, &JitterTrial::isTwofold);
  EXPECT_EQ(trials.end() - pair, 8) << "of four signs and axes, late or early";
  EXPECT_TRUE(std::all_of(pair, trials.end(), [](const JitterTrial& trial) { return trial.isTwofold(); }));
}

TEST(JitterTrials, LeaveTheDistanceOfShifts) {
  JitterEvidence evidence;
  evidence.stated = stated();
  // j' − j of frames 1 and 2, the second off by (0.3, 0.4); of a pair measured thrice the middle one counts.
  evidence.shifts = {{1, {0.375f, -0.875f}}, {2, {-0.625f + 0.3f, 0.375f + 0.4f}}};
  EXPECT_NEAR(shiftResidual({}, evidence), 0.25, 1e-6);
  evidence.shifts.push_back({2, {-0.625f + 30.0f, 0.375f}});
  EXPECT_NEAR(shiftResidual({}, evidence), 0.5, 1e-6);
  EXPECT_TRUE(std::isinf(shiftResidual({}, JitterEvidence())));
}

TEST(JitterTrials, HaveNamesOfTheirOwn) {
  std::set<std::string> ids, texts;
  const auto trials = jitterTrials({160, 96});
  EXPECT_EQ(trials.front().kind, JitterKind::AsStated);
  for (const JitterTrial& trial : trials) {
    EXPECT_TRUE(ids.insert(jitterTrialId(trial)).second) << jitterTrialId(trial);
    EXPECT_TRUE(texts.insert(jitterTrialText(trial)).second) << jitterTrialText(trial);
  }
}

} // namespace taa::doctor
