#include "core/doctor/motion/MotionCorrection.h"

#include "core/base/NumberText.h"

#include <cmath>
#include <string_view>

namespace taa::doctor {

namespace {

using CorrectionSettings = std::vector<std::string>;

/// A third is told by six digits.
std::string factorText(float factor) {
  return roundedText(static_cast<double>(factor), 6);
}

/// Device coordinates point up, texture coordinates down: an axis that points the other way is negated first.
CorrectionSettings unitCorrection(const MotionTrial& trial) {
  const bool isTimesSize = std::abs(trial.factor.x) > 1.0f;
  const bool isOtherAxis = (trial.factor.y < 0.0f) != trial.isDevice;
  std::string unit = isTimesSize ? "as" : "";
  unit += trial.isDevice ? (isTimesSize ? "Ndc" : "ndc") : (isTimesSize ? "Uv" : "uv");
  CorrectionSettings out{"fault.motionUnit=" + unit};
  if (trial.factor.x < 0.0f) out.emplace_back("fault.motionX=-1");
  if (isOtherAxis) out.emplace_back("fault.motionY=-1");
  return out;
}

} // namespace

std::vector<std::string> motionCorrection(const MotionTrial& trial) {
  if (trial.kind == MotionKind::Scaled)
    return {"fault.motionX=" + factorText(trial.factor.x), "fault.motionY=" + factorText(trial.factor.y)};
  if (trial.kind == MotionKind::OtherUnit) return unitCorrection(trial);
  if (madeOf(trial.kind) == MotionMadeOf::OtherCamera) return motionCorrection({MotionKind::OfCamera});
  std::vector<std::string> out;
  for (const std::string_view assignment : motionRow(trial.kind).correction)
    if (!assignment.empty()) out.emplace_back(assignment);
  return out;
}

} // namespace taa::doctor
