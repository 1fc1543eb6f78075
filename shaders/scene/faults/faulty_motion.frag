// Motion vectors with faults. In: those of the source or of an earlier frame, px, and depth, from which the camera's
// part is made. Out: the same, wrong in the region of the faults. The mark of no previous position stays.
#include "include/motion.glsl"
#include "scene/faults/region.glsl"

layout(binding = 0) uniform sampler2D u_motion;
layout(binding = 4) uniform sampler2D u_from; // of this frame or of an earlier one

layout(location = 0) out vec2 o_motion;

// MotionFault, and the unit that is written (MotionUnitFault).
const int kZero = 1;
const int kCameraOnly = 2;
const int kUv = 1;
const int kNdc = 2;
const int kBiased = 3;
const int kRoot = 4;
const int kUnwritten = 5;
const int kAsUv = 6;
const int kAsNdc = 7;
const int kAsBiased = 8;
const int kAsRoot = 9;

bool isMarked(vec2 motion) { return motion.x == kLargestHalf; }

/// Motion of the camera from its frame to another one, without the rounding of what is stored.
vec2 cameraPart(vec4 world, mat4 previousClipFromWorld) {
  precise vec4 clip = frame.clipFromWorld * world;
  precise vec4 previousClip = previousClipFromWorld * world;
  precise vec2 motionPx = (clip.xy * (1.0 / clip.w) - previousClip.xy * (1.0 / previousClip.w)) *
                          (vec2(0.5, -0.5) * frame.sizePx);
  return previousClip.w > 0.0 ? motionPx : kNoPreviousPosition;
}

/// The camera's part taken out, and that of the wrong camera put in.
vec2 withWrongCamera(vec2 motion, vec4 world) {
  vec2 right = cameraPart(world, frame.previousClipFromWorld);
  vec2 wrong = fault.texels.w == 1 ? 2.0 * right : cameraPart(world, fault.wrongPreviousClipFromWorld);
  if (isMarked(motion) || isMarked(right) || isMarked(wrong)) return kNoPreviousPosition;
  precise vec2 result = motion + (wrong - right);
  return result;
}

/// What is stored of a motion in px, taken for px.
vec2 inUnit(vec2 motion) {
  int unit = fault.motionForm.y;
  precise vec2 share = motion / frame.sizePx;
  if (unit == kUv) return share;
  if (unit == kNdc) return vec2(2.0, -2.0) * share;
  if (unit == kBiased) return (0.5 * share + 0.5) * frame.sizePx;
  if (unit == kRoot) return sign(share) * sqrt(abs(share)) * frame.sizePx;
  if (unit == kUnwritten) return -frame.sizePx;
  if (unit == kAsUv) return motion * frame.sizePx;
  if (unit == kAsNdc) return vec2(0.5, -0.5) * (motion * frame.sizePx);
  if (unit == kAsBiased) return 2.0 * motion - frame.sizePx;
  if (unit == kAsRoot) return abs(motion) * share;
  return motion;
}

vec2 faulty(vec2 motion, vec4 world) {
  if (fault.motionForm.x == kZero) motion = vec2(0.0);
  if (fault.motionForm.x == kCameraOnly) motion = cameraPart(world, frame.previousClipFromWorld);
  if (kWrongCamera) motion = withWrongCamera(motion, world);
  if (isMarked(motion)) return motion;
  precise vec2 jittered = motion + fault.motionTerms.z * fault.jitter.xy - fault.motionTerms.w * fault.jitter.zw;
  if (fault.motionForm.z == 1) jittered = jittered.yx;
  precise vec2 scaled = jittered * fault.motionTerms.xy;
  vec2 result = inUnit(scaled);
  return fault.motionForm.w == 1 && result == vec2(0.0) ? kNoPreviousPosition : result;
}

/// The middle of the larger texel that holds a texel.
ivec2 coarse(ivec2 texel, int side) { return texel / side * side + side / 2; }

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  ivec2 last = textureSize(u_motion, 0) - 1;
  vec2 motion = texelFetch(u_motion, texel, 0).rg;
  if (isInRegion(texel)) {
    ivec2 from = clamp(coarse(texel, fault.texels.y) - fault.texels.x, ivec2(0), last);
    vec4 world = worldPosition(gl_FragCoord.xy, texelFetch(u_depth, texel, 0).r);
    motion = faulty(texelFetch(u_from, from, 0).rg, world);
    if (any(greaterThanEqual(abs(motion), vec2(kLargestHalf)))) motion = kNoPreviousPosition;
    motion = storedMotion(motion);
  }
  o_motion = motion;
}
