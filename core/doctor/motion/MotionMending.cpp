#include "core/doctor/motion/MotionMending.h"

#include "core/base/NumberText.h"

#include <cmath>

namespace taa::doctor {

namespace {

using MendingSettings = std::vector<std::string>;

/// A third is told by six digits.
std::string factorText(float factor) {
  return roundedText(static_cast<double>(factor), 6);
}

/// Device coordinates point up, texture coordinates down: an axis that points the other way is negated first.
MendingSettings unitMending(const MotionTrial& trial) {
  const bool isTimesSize = std::abs(trial.factor.x) > 1.0f;
  const bool isOtherAxis = (trial.factor.y < 0.0f) != trial.isDevice;
  std::string unit = isTimesSize ? "as" : "";
  unit += trial.isDevice ? (isTimesSize ? "Ndc" : "ndc") : (isTimesSize ? "Uv" : "uv");
  MendingSettings out{"fault.motionUnit=" + unit};
  if (trial.factor.x < 0.0f) out.emplace_back("fault.motionX=-1");
  if (isOtherAxis) out.emplace_back("fault.motionY=-1");
  return out;
}

} // namespace

std::vector<std::string> motionMending(const MotionTrial& trial) {
  switch (trial.kind) {
  case MotionKind::AsGiven:
  case MotionKind::TwoFramesOld: // what an earlier frame added is not known of what moves
    return {};
  case MotionKind::Resting:
    return {"fault.motion=zero"};
  case MotionKind::OfCamera:
  case MotionKind::CameraTurned:
  case MotionKind::CameraBeside:
  case MotionKind::CameraMirrored:
  case MotionKind::CameraUnzoomed:
  case MotionKind::CameraUnmoved:
  case MotionKind::CameraUnturned:
  case MotionKind::CameraIdentity:
    return {"fault.motion=cameraOnly"};
  case MotionKind::LacksCamera:
    return {"fault.previousCamera=twice"};
  case MotionKind::CameraTwice:
    return {"fault.previousCamera=ofNow"};
  case MotionKind::Scaled:
    return {"fault.motionX=" + factorText(trial.factor.x), "fault.motionY=" + factorText(trial.factor.y)};
  case MotionKind::OtherUnit:
    return unitMending(trial);
  case MotionKind::MirroredX:
    return {"fault.motionX=-1"};
  case MotionKind::MirroredY:
    return {"fault.motionY=-1"};
  case MotionKind::Opposite:
    return {"fault.motionX=-1", "fault.motionY=-1"};
  case MotionKind::SwappedAxes:
    return {"fault.motionSwapped=on"};
  case MotionKind::JitterOfThis:
    return {"fault.motionJitter=thisOff"};
  case MotionKind::JitterOfPrevious:
    return {"fault.motionJitter=lastOff"};
  case MotionKind::JitterOfBoth:
    return {"fault.motionJitter=bothOff"};
  case MotionKind::JitterTakenOff:
    return {"fault.motionJitter=both"};
  case MotionKind::JitterOfThisTakenOff:
    return {"fault.motionJitter=this"};
  case MotionKind::JitterOfPreviousTakenOff:
    return {"fault.motionJitter=last"};
  case MotionKind::FrameLate:
    return {"fault.motionLag=-1"};
  case MotionKind::FrameEarly:
    return {"fault.motionLag=1"};
  case MotionKind::TurnedLeft: // no setting turns
  case MotionKind::TurnedRight:
  case MotionKind::Forward: // … or looks for the same surface
    return {};
  case MotionKind::Encoded:
    return {"fault.motionUnit=asBiased"};
  case MotionKind::Root:
    return {"fault.motionUnit=asRoot"};
  }
  return {};
}

} // namespace taa::doctor
