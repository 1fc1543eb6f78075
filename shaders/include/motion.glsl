// Motion vectors: current − previous position, px, y down, jitter removed (manual §3). Both positions go
// through the same arithmetic, so that what does not move has exactly 0.
#include "include/storage.glsl"

/// The mark of a point without a previous position; kNoPreviousPosition in C++.
const vec2 kNoPreviousPosition = vec2(kLargestHalf);

/// As it is stored; the mark where the point lay behind the previous camera, at a w of 0 or less (manual §3, rule 2).
vec2 checkedMotion(vec2 motionPx, float previousW) {
  // Comparisons are written so that NaN fails them.
  bool isVisible = previousW > 0.0 && all(lessThan(abs(motionPx), vec2(kLargestHalf)));
  return isVisible ? storedMotion(motionPx) : kNoPreviousPosition;
}

/// From interpolated clip positions (x, y, w) of both frames, divided here, per pixel (manual §3, rule 1).
vec2 motionFromClip(vec3 clip, vec3 previousClip) {
  precise vec2 ndc = clip.xy * (1.0 / clip.z);
  precise vec2 previousNdc = previousClip.xy * (1.0 / previousClip.z);
  precise vec2 motionPx = (ndc - previousNdc) * (vec2(0.5, -0.5) * frame.sizePx);
  return checkedMotion(motionPx, previousClip.z);
}

/// As printed in source 001's listing of meshes (manual §26, D6): the current position is not divided by its w.
vec2 printedMotion(vec3 clip, vec3 previousClip) {
  precise vec2 previousNdc = previousClip.xy * (1.0 / previousClip.z);
  precise vec2 motionPx = (clip.xy - previousNdc) * (vec2(0.5, -0.5) * frame.sizePx);
  return checkedMotion(motionPx, previousClip.z);
}

/// Normalized device coordinates (y up) of a window position.
vec2 ndcOf(vec2 windowPx) { return vec2(2.0, -2.0) * (windowPx / frame.sizePx) + vec2(-1.0, 1.0); }

/// Homogeneous world position of the sample that pixel `pixel` (gl_FragCoord.xy) holds at device depth `depth`.
/// With perspective, depth 0 is the sky: a direction, w = 0. With an orthographic camera it is the far plane.
vec4 worldPosition(vec2 pixel, float depth) {
  vec4 world = frame.worldFromJitteredClip * vec4(ndcOf(pixel), depth, 1.0);
  if (depth == 0.0) world.w *= frame.cameraPosition.w;
  return world;
}

/// Motion of a point that stands still in the world (manual §3.1), or infinitely far away when w = 0 (manual §3.2).
vec2 cameraMotion(vec4 world) {
  precise vec4 clip = frame.clipFromWorld * world;
  precise vec4 previousClip = frame.previousClipFromWorld * world;
  return motionFromClip(clip.xyw, previousClip.xyw);
}
