// Stage 6, validate history: off the screen, or another surface's.
#include "core/taa/twin/Color.h"
#include "core/taa/twin/CompareDepth.h"
#include "core/taa/twin/Instances.h"
#include "core/taa/twin/Stages.h"

namespace taa::twin {
namespace {

/// By the chosen rule (manual 5.0, 5.1, 5.3, 5.7); NaN is outside.
template <typename Real>
bool isOutside(const Inputs& inputs, OffScreen rule, const Vec2<Real>& q) {
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
template <typename Real>
RejectReason rejectReason(const Inputs& inputs, const ValidateSettings& settings,
                          const ReprojectionOf<Real>& reprojected, const GeometryMatchOf<Real>& geometry,
                          bool isOtherDepth, Real changed) {
  const auto isOn = [](Switch value) { return value == Switch::On; };
  if (inputs.historyColor.empty()) return RejectReason::NoHistory;
  if (reprojected.noPrevious) return RejectReason::NoPrevious;
  if (isOutside(inputs, settings.offScreen, reprojected.position)) return RejectReason::OffScreen;
  if (isOn(settings.depth) && isOtherDepth) return RejectReason::Depth;
  if (isOn(settings.object) && !geometry.isSameObject) return RejectReason::Object;
  if (isOn(settings.objectClass) && !geometry.isSameClass) return RejectReason::Class;
  if (isOn(settings.normal) && geometry.normalAgreement < number<Real>(settings.normalLimit))
    return RejectReason::Normal;
  if (isOn(settings.speed) && reprojected.speed > number<Real>(settings.speedLimit))
    return RejectReason::Speed;
  return changed > 0.0f ? RejectReason::Velocity : RejectReason::Kept;
}

} // namespace

template <typename Real>
ValidityOf<Real> validateHistory(const Inputs& inputs, const ValidateSettings& settings,
                                 const DilatedMotionOf<Real>& dilated,
                                 const ReprojectionOf<Real>& reprojected, const Vec2<Real>& readPosition,
                                 const glm::ivec2& pixel, const GeometryMatchOf<Real>& geometry) {
  const DepthTestOf<Real> depth = compareDepth(inputs, settings, dilated, pixel, readPosition);
  if (settings.depth == Switch::Off)
    searched<Real>(); // what depth says is shown, and decides nothing
  else if (settings.flicker == Switch::On)
    decided<Real>(IntermediateId::geometricFlicker, false);
  ValidityOf<Real> result;
  result.depthExpected = depth.expected;
  result.historyDepth = depth.stored;
  result.depthMismatch = depth.mismatch;
  result.depthAllowed = depth.allowed;
  Real changed = 0.0f; // share that a change of velocity rejects, 12.5
  if (settings.velocity != VelocityTest::None)
    changed = saturated((geometry.velocityChange - number<Real>(settings.velocityLimit)) *
                        number<Real>(settings.velocityGain));
  result.reason = rejectReason(inputs, settings, reprojected, geometry, depth.isOther, changed);
  decided<Real>(IntermediateId::rejectReason);
  result.isFlicker = depth.isFlicker && result.reason == RejectReason::Kept;
  if (result.reason == RejectReason::Kept) return result;
  result.isFrozen = result.reason == RejectReason::OffScreen && settings.offScreen == OffScreen::OneSided;
  if (result.isFrozen) return result;
  const bool isSoft = settings.action == RejectAction::RaiseAlpha && result.reason >= RejectReason::Depth;
  const Real whole = isSoft ? number<Real>(settings.softAlpha) : Real(1.0f);
  result.invalid = result.reason == RejectReason::Velocity ? changed * whole : whole;
  return result;
}

template <typename Real>
Real lengthLeft(const ValidateSettings& settings, Real historyLength, const ValidityOf<Real>& validated) {
  return settings.action == RejectAction::Decay ? historyLength * (1.0f - validated.invalid) : historyLength;
}

#define TAA_VALIDATE(Real)                                                                                   \
  template Real lengthLeft(const ValidateSettings& settings, Real historyLength,                             \
                           const ValidityOf<Real>& validated);                                               \
  template ValidityOf<Real> validateHistory(                                                                 \
      const Inputs& inputs, const ValidateSettings& settings, const DilatedMotionOf<Real>& dilated,          \
      const ReprojectionOf<Real>& reprojected, const Vec2<Real>& readPosition, const glm::ivec2& pixel,      \
      const GeometryMatchOf<Real>& geometry);
TAA_EACH_NUMBER(TAA_VALIDATE)
#undef TAA_VALIDATE

} // namespace taa::twin
