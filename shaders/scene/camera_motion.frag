// Motion of the camera alone, from the depth buffer (manual §3.1, §3.2): what an engine has whose objects
// write no motion. Every surface is taken to stand still in the world. Specialised by kMotionSource.
#include "include/motion.glsl"

layout(binding = 0) uniform sampler2D u_depth;

layout(location = 0) out vec2 o_motion;
layout(location = 1) out float o_previousDepth;

vec4 previousClipOf(vec4 world) {
  precise vec4 clip = frame.previousClipFromWorld * world;
  return clip;
}

/// 3.1a: from the pixel's center, wherever its sample lies.
vec2 rawMotion(vec4 world) {
  vec4 previousClip = previousClipOf(world);
  precise vec2 motionPx =
      (ndcOf(gl_FragCoord.xy) - previousClip.xy * (1.0 / previousClip.w)) * (vec2(0.5, -0.5) * frame.sizePx);
  return checkedMotion(motionPx, previousClip.w);
}

/// 3.1b: both positions with their frame's jitter, of which `jitterShare` is subtracted again.
vec2 jitteredMotion(vec4 world, float jitterShare, vec2 pxPerNdc) {
  vec2 jitterNdc = vec2(2.0, -2.0) * (frame.jitterPx / frame.sizePx);
  vec2 previousJitterNdc = vec2(2.0, -2.0) * (frame.previousJitter.xy / frame.sizePx);
  vec4 previousClip = previousClipOf(world);
  precise vec2 previousNdc = previousClip.xy * (1.0 / previousClip.w) + previousJitterNdc;
  precise vec2 motionNdc =
      (ndcOf(gl_FragCoord.xy) - previousNdc) - jitterShare * (jitterNdc - previousJitterNdc);
  return checkedMotion(motionNdc * pxPerNdc, previousClip.w);
}

/// 3.1c: one matrix, the pixel taken for unjittered.
vec2 singleMatrixMotion(float depth) {
  vec2 ndc = ndcOf(gl_FragCoord.xy);
  precise vec4 previousClip = frame.previousClipFromClip * vec4(ndc, depth, 1.0);
  return motionFromClip(vec3(ndc, 1.0), previousClip.xyw);
}

void main() {
  float depth = texelFetch(u_depth, ivec2(gl_FragCoord.xy), 0).r;
  vec4 world = worldPosition(gl_FragCoord.xy, depth);
  float previousDepthView = -(frame.previousViewFromWorld * world).z / world.w;
  o_previousDepth = depth > 0.0 && previousDepthView > 0.0 ? previousDepthView : 0.0;
  if (kMotionSource == kRawUv)
    o_motion = rawMotion(world);
  else if (kMotionSource == kJitterDifference)
    o_motion = jitteredMotion(world, 1.0, vec2(0.5, -0.5) * frame.sizePx);
  else if (kMotionSource == kJitterDifferenceAsPrinted)
    // D5: NDC for texture coordinates, y up for y down; jitter in texture coordinates.
    o_motion = jitteredMotion(world, 0.5, frame.sizePx);
  else if (kMotionSource == kSingleMatrix)
    o_motion = singleMatrixMotion(depth);
  else
    o_motion = cameraMotion(world);
}
