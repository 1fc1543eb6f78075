// Stage 6, validate history: off the screen, or another surface's.
#include "core/taa/twin/Color.h"
#include "core/taa/twin/CompareDepth.h"
#include "core/taa/twin/Stages.h"

namespace taa::twin {
namespace {

/// By the chosen rule (manual 5.0, 5.1, 5.3, 5.7); NaN is outside.
bool isOutside(const Inputs& inputs, OffScreen rule, const glm::vec2& q) {
  const auto isBeyond = [&](float margin) {
    return !(q.x >= margin && q.x <= static_cast<float>(inputs.outputWidth()) - margin && q.y >= margin &&
             q.y <= static_cast<float>(inputs.outputHeight()) - margin);
  };
  switch (rule) {
  case OffScreen::Keep:
    return false;
  case OffScreen::Reject:
    return isBeyond(0.0f);
  case OffScreen::Margin:
    return isBeyond(0.5f);
  case OffScreen::OneSided:
    return !(q.x > 0.0f);
  }
  return false;
}

/// The first of the reasons to reject history, the weightiest first.
RejectReason rejectReason(const Inputs& inputs, const ValidateSettings& settings,
                          const Reprojection& reprojected, const GeometryMatch& geometry, bool isOtherDepth,
                          float changed) {
  const auto isOn = [](Switch value) { return value == Switch::On; };
  if (inputs.historyColor.empty()) return RejectReason::NoHistory;
  if (reprojected.noPrevious) return RejectReason::NoPrevious;
  if (isOutside(inputs, settings.offScreen, reprojected.position)) return RejectReason::OffScreen;
  if (isOn(settings.depth) && isOtherDepth) return RejectReason::Depth;
  if (isOn(settings.object) && !geometry.isSameObject) return RejectReason::Object;
  if (isOn(settings.objectClass) && !geometry.isSameClass) return RejectReason::Class;
  if (isOn(settings.normal) && geometry.normalAgreement < settings.normalLimit) return RejectReason::Normal;
  if (isOn(settings.speed) && reprojected.speed > settings.speedLimit) return RejectReason::Speed;
  return changed > 0.0f ? RejectReason::Velocity : RejectReason::Kept;
}

} // namespace

Validity validateHistory(const Inputs& inputs, const ValidateSettings& settings, const DilatedMotion& dilated,
                         const Reprojection& reprojected, const glm::vec2& readPosition,
                         const glm::ivec2& pixel, const GeometryMatch& geometry) {
  const DepthTest depth = compareDepth(inputs, settings, dilated, pixel, readPosition);
  Validity result;
  result.depthExpected = depth.expected;
  result.historyDepth = depth.stored;
  result.depthMismatch = depth.mismatch;
  result.depthAllowed = depth.allowed;
  float changed = 0.0f; // share that a change of velocity rejects, 12.5
  if (settings.velocity != VelocityTest::None)
    changed = saturated((geometry.velocityChange - settings.velocityLimit) * settings.velocityGain);
  result.reason = rejectReason(inputs, settings, reprojected, geometry, depth.isOther, changed);
  result.isFlicker = depth.isFlicker && result.reason == RejectReason::Kept;
  if (result.reason == RejectReason::Kept) return result;
  result.isFrozen = result.reason == RejectReason::OffScreen && settings.offScreen == OffScreen::OneSided;
  if (result.isFrozen) return result;
  const bool isSoft = settings.action == RejectAction::RaiseAlpha && result.reason >= RejectReason::Depth;
  const float whole = isSoft ? settings.softAlpha : 1.0f;
  result.invalid = result.reason == RejectReason::Velocity ? changed * whole : whole;
  return result;
}

float lengthLeft(const ValidateSettings& settings, float historyLength, const Validity& validated) {
  return settings.action == RejectAction::Decay ? historyLength * (1.0f - validated.invalid) : historyLength;
}

} // namespace taa::twin
