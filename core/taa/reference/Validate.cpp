// Stage 7, validate history: off the screen, or another surface's.
#include "core/taa/reference/Color.h"
#include "core/taa/reference/Stages.h"

#include <cmath>

namespace taa::reference {
namespace {

/// Relative difference of view depths; the sky matches only the sky.
float mismatch(float expected, float stored) {
  if (expected == 0.0f && stored == 0.0f) return 0.0f;
  if (expected == 0.0f || stored == 0.0f) return 1.0f;
  return std::fabs(expected - stored) / expected;
}

/// Of the four texels around the position, the depth that fits best.
void compareDepth(const Inputs& inputs, const glm::vec2& position, Validated& result) {
  const glm::ivec2 corner(static_cast<int>(std::floor(position.x - 0.5f)),
                          static_cast<int>(std::floor(position.y - 0.5f)));
  for (int k = 0; k < 4; ++k) {
    const glm::ivec2 texel = clampedToPicture(corner + glm::ivec2(k % 2, k / 2), inputs);
    const float stored = inputs.historySurface.texel(texel.x, texel.y).y;
    const float difference = mismatch(result.depthExpected, stored);
    if (k == 0 || difference < result.depthMismatch) {
      result.historyDepth = stored;
      result.depthMismatch = difference;
    }
  }
}

/// |dz| to the neighbors at ± step: the smaller one, since a silhouette is on one side only; the sky is no
/// neighbor.
float depthStep(const Inputs& inputs, const glm::ivec2& pixel, const glm::ivec2& step, float center) {
  float smallest = -1.0f;
  for (const glm::ivec2& neighbor : {pixel - step, pixel + step}) {
    const glm::ivec2 texel = clampedToDrawn(neighbor, inputs);
    const float depth = viewDepth(inputs.depth.texel(texel.x, texel.y).x, inputs.depthTerms);
    if (depth == 0.0f) continue;
    const float difference = std::fabs(depth - center);
    if (smallest < 0.0f || difference < smallest) smallest = difference;
  }
  return smallest < 0.0f ? 0.0f : smallest;
}

/// τ and the share of the surface's slope (catalogue 12.1: grazing surfaces need a slope term).
float allowedMismatch(const Inputs& inputs, const ValidateSettings& settings, const glm::ivec2& pixel,
                      float expected) {
  const float center = viewDepth(inputs.depth.texel(pixel.x, pixel.y).x, inputs.depthTerms);
  if (expected == 0.0f || center == 0.0f) return settings.depthTolerance;
  return settings.depthTolerance + (settings.slopeAllowance * depthSlope(inputs, pixel)) / expected;
}

/// By the chosen rule (catalogue 5.0, 5.1, 5.3, 5.7); NaN is outside.
bool isOutside(const Inputs& inputs, OffScreen rule, const glm::vec2& q) {
  if (rule == OffScreen::Keep) return false;
  if (rule == OffScreen::OneSided) return !(q.x > 0.0f);
  const float margin = rule == OffScreen::Margin ? 0.5f : 0.0f;
  return !(q.x >= margin && q.x <= static_cast<float>(inputs.outputWidth()) - margin && q.y >= margin &&
           q.y <= static_cast<float>(inputs.outputHeight()) - margin);
}

/// The first of the reasons to reject history, the weightiest first.
RejectReason reasonOf(const Inputs& inputs, const ValidateSettings& settings, const Reprojected& reprojected,
                      const GeometryMatch& geometry, const Validated& depths, float changed) {
  const auto isOn = [](Switch value) { return value == Switch::On; };
  if (inputs.historyColor.empty()) return RejectReason::NoHistory;
  if (reprojected.noPrevious) return RejectReason::NoPrevious;
  if (isOutside(inputs, settings.offScreen, reprojected.position)) return RejectReason::OffScreen;
  if (isOn(settings.depth) && depths.depthMismatch > depths.depthAllowed) return RejectReason::Depth;
  if (isOn(settings.object) && !geometry.isSameObject) return RejectReason::Object;
  if (isOn(settings.objectClass) && !geometry.isSameClass) return RejectReason::Class;
  if (isOn(settings.normal) && geometry.normalAgreement < settings.normalLimit) return RejectReason::Normal;
  if (isOn(settings.speed) && reprojected.speed > settings.speedLimit) return RejectReason::Speed;
  return changed > 0.0f ? RejectReason::Velocity : RejectReason::Kept;
}

} // namespace

float depthSlope(const Inputs& inputs, const glm::ivec2& drawn) {
  const float center = viewDepth(inputs.depth.texel(drawn.x, drawn.y).x, inputs.depthTerms);
  return depthStep(inputs, drawn, {1, 0}, center) + depthStep(inputs, drawn, {0, 1}, center);
}

Validated validateHistory(const Inputs& inputs, const ValidateSettings& settings, const Dilated& dilated,
                          const Reprojected& reprojected, const glm::vec2& readPosition,
                          const glm::ivec2& pixel, const GeometryMatch& geometry) {
  Validated result;
  const glm::ivec2 chosen = pixel + dilated.offset;
  result.depthExpected = inputs.previousDepth.texel(chosen.x, chosen.y).x;
  result.depthAllowed = allowedMismatch(inputs, settings, pixel, result.depthExpected);
  if (!inputs.historyColor.empty()) compareDepth(inputs, readPosition, result);
  float changed = 0.0f; // share that a change of velocity rejects, 12.5
  if (settings.velocity != VelocityTest::None)
    changed = saturated((geometry.velocityChange - settings.velocityLimit) * settings.velocityGain);
  result.reason = reasonOf(inputs, settings, reprojected, geometry, result, changed);
  if (result.reason == RejectReason::Kept) return result;
  result.isFrozen = result.reason == RejectReason::OffScreen && settings.offScreen == OffScreen::OneSided;
  if (result.isFrozen) return result;
  const bool isSoft = settings.action == RejectAction::RaiseAlpha && result.reason >= RejectReason::Depth;
  const float whole = isSoft ? settings.softAlpha : 1.0f;
  result.invalid = result.reason == RejectReason::Velocity ? changed * whole : whole;
  return result;
}

float lengthLeft(const ValidateSettings& settings, float length, const Validated& validated) {
  return settings.action == RejectAction::Decay ? length * (1.0f - validated.invalid) : length;
}

} // namespace taa::reference
