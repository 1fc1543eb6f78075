// Settings that undo what is wrong with motion: the formula of each undoes that of the explanation.
#include "core/doctor/motion/MotionCorrection.h"

#include "core/settings/Parameters.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>

#include <string>
#include <vector>

namespace taa::doctor {
namespace {

constexpr glm::ivec2 kPx{320, 180};
const glm::vec2 kJitter{0.25f, -0.375f}, kJitterBefore{-0.125f, 0.3125f};

/// What the settings make of a motion: the formulas of their table.
glm::vec2 madeBy(const FaultSettings& faults, glm::vec2 motion) {
  const glm::vec2 size(kPx);
  switch (faults.motionJitter) {
  case MotionJitterFault::Both:
    motion += kJitter - kJitterBefore;
    break;
  case MotionJitterFault::ThisOff:
    motion -= kJitter;
    break;
  case MotionJitterFault::LastOff:
    motion += kJitterBefore;
    break;
  case MotionJitterFault::BothOff:
    motion -= kJitter - kJitterBefore;
    break;
  default:
    break;
  }
  if (isOn(faults.motionSwapped)) motion = {motion.y, motion.x};
  motion *= glm::vec2(faults.motionX, faults.motionY);
  switch (faults.motionUnit) {
  case MotionUnitFault::Uv:
    return motion / size;
  case MotionUnitFault::Ndc:
    return glm::vec2(2.0f, -2.0f) * motion / size;
  case MotionUnitFault::AsUv:
    return motion * size;
  case MotionUnitFault::AsNdc:
    return glm::vec2(0.5f, -0.5f) * motion * size;
  case MotionUnitFault::AsBiased:
    return 2.0f * motion - size;
  case MotionUnitFault::AsRoot:
    return glm::abs(motion) * motion / size;
  default:
    return motion;
  }
}

bool isOfOneFrame(MotionKind kind) {
  switch (kind) {
  case MotionKind::Scaled:
  case MotionKind::OtherUnit:
  case MotionKind::MirroredX:
  case MotionKind::MirroredY:
  case MotionKind::Opposite:
  case MotionKind::SwappedAxes:
  case MotionKind::JitterOfThis:
  case MotionKind::JitterOfPrevious:
  case MotionKind::JitterOfBoth:
  case MotionKind::JitterTakenOff:
  case MotionKind::Encoded:
  case MotionKind::Root:
    return true;
  default:
    return false;
  }
}

} // namespace

TEST(MotionCorrection, MakesTheMotionThatTheExplanationSays) {
  DoctorFrame now, before;
  now.luma = Image(kPx.x, kPx.y, 1);
  now.motionPx = Image(kPx.x, kPx.y, 2);
  now.motionPx.at(3, 2)[0] = 5.5f;
  now.motionPx.at(3, 2)[1] = -2.25f;
  now.jitterPx = kJitter;
  before.jitterPx = kJitterBefore;
  int tried = 0;
  for (const MotionTrial& trial : motionTrials(kPx)) {
    if (!isOfOneFrame(trial.kind)) continue;
    Settings settings;
    for (const std::string& assignment : motionCorrection(trial)) applyAssignment(settings, assignment);
    const glm::vec2 is = madeBy(settings.fault, now.motionAt(3, 2)),
                    should = *trueMotion(trial, {now, before}, {3, 2});
    EXPECT_NEAR(is.x, should.x, 1e-5f * glm::abs(should.x)) << trialId(trial) << ": six digits";
    EXPECT_NEAR(is.y, should.y, 1e-5f * glm::abs(should.y)) << trialId(trial);
    ++tried;
  }
  EXPECT_EQ(tried, 36);
}

TEST(MotionCorrection, SaysWhatAllOthersAre) {
  using Words = std::vector<std::string>;
  EXPECT_EQ(motionCorrection({MotionKind::OfCamera}), Words{"fault.motion=cameraOnly"});
  EXPECT_EQ(motionCorrection({MotionKind::Resting}), Words{"fault.motion=zero"});
  EXPECT_EQ(motionCorrection({MotionKind::LacksCamera}), Words{"fault.previousCamera=twice"});
  EXPECT_EQ(motionCorrection({MotionKind::CameraTwice}), Words{"fault.previousCamera=ofNow"});
  EXPECT_EQ(motionCorrection({MotionKind::FrameLate}), Words{"fault.motionLag=-1"});
  EXPECT_EQ(motionCorrection({MotionKind::FrameEarly}), Words{"fault.motionLag=1"});
  EXPECT_EQ(motionCorrection({MotionKind::AsGiven}), Words());
  EXPECT_EQ(motionCorrection({MotionKind::TwoFramesOld}), Words());
}

} // namespace taa::doctor
