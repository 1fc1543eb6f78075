// Decides whether history shows the same surface (catalogue §5, §12). In: the render texel, where depth and motion came
// from, the reprojection, and what is stored with history. Out: a reject reason, and how much that weighs.

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
};

/// Difference of a stored depth to the expected one, relative to that; the sky matches only the sky.
float depthMismatch(float expected, float stored) {
  precise float relative = abs(expected - stored) / expected;
  bool isSky = expected == 0.0;
  bool wasSky = stored == 0.0;
  return mix(mix(relative, 1.0, isSky || wasSky), 0.0, isSky && wasSky);
}

struct DepthMatch {
  float depth;    // m
  float mismatch; // relative
};

/// The best of the four stored depths around the position: the surface is one of them unless it was hidden.
DepthMatch bestMatch(float expected, float depths[4]) {
  DepthMatch best = DepthMatch(depths[0], depthMismatch(expected, depths[0]));
  for (int k = 1; k < 4; ++k) {
    float mismatch = depthMismatch(expected, depths[k]);
    bool isBetter = mismatch < best.mismatch;
    best = DepthMatch(mix(best.depth, depths[k], isBetter), mix(best.mismatch, mismatch, isBetter));
  }
  return best;
}

/// Change of view depth, m, to that of two opposite neighbors which is on the same surface; 0 when both are sky.
float smallerStep(float center, float a, float b) {
  precise float toA = abs(a - center);
  precise float toB = abs(b - center);
  bool isSkyA = a == 0.0;
  bool isSkyB = b == 0.0;
  float besideSky = mix(mix(toA, toB, isSkyA), 0.0, isSkyA && isSkyB);
  return mix(lesser(toA, toB), besideSky, isSkyA || isSkyB);
}

float viewDepthAt(ivec2 texel) { return viewDepth(texelAt(u_depth, texel).r); }

/// Mismatch that still counts as the same surface: jitter and dilation move a sample along its slope.
float allowedMismatch(ivec2 texel, float expected) {
  float center = viewDepthAt(texel);
  float x = smallerStep(center, viewDepthAt(texel - ivec2(1, 0)), viewDepthAt(texel + ivec2(1, 0)));
  float y = smallerStep(center, viewDepthAt(texel - ivec2(0, 1)), viewDepthAt(texel + ivec2(0, 1)));
  precise float slope = x + y;
  precise float sloped = settings.validateDepthTolerance + (settings.validateSlopeAllowance * slope) / expected;
  return mix(sloped, settings.validateDepthTolerance, expected == 0.0 || center == 0.0);
}

/// The weightiest of what speaks against history.
int rejectReason(Reprojection reprojection, bool isDeeper, GeometryMatch geometry, float changed) {
  int reason = kRejectReason_kept;
  if (changed > 0.0) reason = kRejectReason_velocity;
  if (kValidateSpeed && reprojection.speed > settings.validateSpeedLimit) reason = kRejectReason_speed;
  if (kValidateNormal && geometry.normalAgreement < settings.validateNormalLimit) reason = kRejectReason_normal;
  if (kValidateClass && !geometry.isSameClass) reason = kRejectReason_class;
  if (kValidateObject && !geometry.isSameObject) reason = kRejectReason_object;
  if (kValidateDepth && isDeeper) reason = kRejectReason_depth;
  if (reprojection.isOutside) reason = kRejectReason_offScreen;
  if (!reprojection.hasPrevious) reason = kRejectReason_noPrevious;
  return hasHistory() ? reason : kRejectReason_noHistory;
}

/// Source 002's first test of the border keeps all of the history that it finds invalid (§26, D9).
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
  float expected = texelAt(u_previousDepth, texel + ivec2(dilated.offset)).r;
  DepthMatch match = DepthMatch(0.0, 0.0);
  if (hasHistory()) match = bestMatch(expected, history.depths);

  float allowed = allowedMismatch(texel, expected);
  GeometryMatch geometry = compareGeometry(texel, dilated, history.position);
  float changed = changedShare(geometry.velocityChange);
  int reason = rejectReason(reprojection, match.mismatch > allowed, geometry, changed);
  expose_depthExpected(expected);
  expose_historyDepth(match.depth);
  expose_depthMismatch(match.mismatch);
  expose_depthAllowed(allowed);
  expose_rejectReason(float(reason));
  return Validity(reason, invalidity(reason, changed), geometry.velocityChange, isFrozenBy(reason));
}

const bool kDecays = kValidateAction == kValidateAction_decay;

/// N once it has decayed by what is rejected (Godot).
float framesLeft(float frames, Validity validity) {
  precise float left = frames * (1.0 - validity.invalid);
  return kDecays ? left : frames;
}
