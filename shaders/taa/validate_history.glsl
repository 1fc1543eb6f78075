// Decides whether history shows the same surface (manual §5, §12). In: the render texel, where depth and motion came
// from, the reprojection, and what is stored with history. Out: a reject reason, and how much that weighs.

#include "taa/compare_depth.glsl"
#include "taa/compare_geometry.glsl"

const int kRejectReason_kept = 0;
const int kRejectReason_noHistory = 1;
const int kRejectReason_noPrevious = 2;
const int kRejectReason_offScreen = 3;
const int kRejectReason_depth = 4;
const int kRejectReason_speed = 5;
const int kRejectReason_object = 6;
const int kRejectReason_class = 7;
const int kRejectReason_normal = 8;
const int kRejectReason_velocity = 9;

struct Validity {
  int reason;
  float invalid;        // least α: 1 where history is dropped, 0 where it is kept
  float velocityChange; // px a frame
  bool isFrozen;        // beyond the border that is tested as printed: nothing of the current frame is taken
  bool isFlicker;       // kept, though its depth differs
};

/// The weightiest of what speaks against history.
int rejectReason(Reprojection reprojection, bool isOther, GeometryMatch geometry, float changed) {
  int reason = kRejectReason_kept;
  if (changed > 0.0) reason = kRejectReason_velocity;
  if (kValidateSpeed && reprojection.speed > settings.validateSpeedLimit) reason = kRejectReason_speed;
  if (kValidateNormal && geometry.normalAgreement < settings.validateNormalLimit) reason = kRejectReason_normal;
  if (kValidateClass && !geometry.isSameClass) reason = kRejectReason_class;
  if (kValidateObject && !geometry.isSameObject) reason = kRejectReason_object;
  if (kValidateDepth && isOther) reason = kRejectReason_depth;
  if (reprojection.isOutside) reason = kRejectReason_offScreen;
  if (!reprojection.hasPrevious) reason = kRejectReason_noPrevious;
  return hasHistory() ? reason : kRejectReason_noHistory;
}

/// Source 002's first test of the border keeps all of the history that it finds invalid (manual §26, D9).
bool isFrozenBy(int reason) {
  return kValidateOffScreen == kValidateOffScreen_oneSided && reason == kRejectReason_offScreen;
}

/// Least α for a reason: what is off the screen or not there starts anew whatever is chosen.
float invalidity(int reason, float changed) {
  if (isFrozenBy(reason)) return 0.0;
  bool isSoft = kValidateAction == kValidateAction_raiseAlpha && reason >= kRejectReason_depth;
  float whole = mix(1.0, settings.validateSoftAlpha, isSoft);
  precise float part = changed * whole;
  return mix(mix(whole, part, reason == kRejectReason_velocity), 0.0, reason == kRejectReason_kept);
}

/// Share of history that a change of velocity rejects (12.5).
float changedShare(float velocityChange) {
  if (kValidateVelocity == kValidateVelocity_none) return 0.0;
  precise float share = (velocityChange - settings.validateVelocityLimit) * settings.validateVelocityGain;
  return saturated(share);
}

Validity validateHistory(ivec2 texel, DilatedMotion dilated, Reprojection reprojection, HistorySample history) {
  DepthTest depth = compareDepth(texel, dilated, history.position);
  GeometryMatch geometry = compareGeometry(texel, dilated, history.position);
  float changed = changedShare(geometry.velocityChange);
  int reason = rejectReason(reprojection, depth.isOther, geometry, changed);
  bool isFlicker = depth.isFlicker && reason == kRejectReason_kept;
  expose_geometricFlicker(isFlicker ? 1.0 : 0.0);
  expose_rejectReason(float(reason));
  return Validity(reason, invalidity(reason, changed), geometry.velocityChange, isFrozenBy(reason), isFlicker);
}

const bool kDecays = kValidateAction == kValidateAction_decay;

/// N once it has decayed by what is rejected (Godot).
float lengthLeft(float historyLength, Validity validity) {
  precise float left = historyLength * (1.0 - validity.invalid);
  return kDecays ? left : historyLength;
}
