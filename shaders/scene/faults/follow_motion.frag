// Motion from transforms that are older than those of the last frame: the motion of an earlier frame, read where this
// one leads, is added in the region of the faults. In: motion so far, px, and that of the earlier frame. Out: their sum.
#include "include/motion.glsl"
#include "scene/faults/region.glsl"

layout(binding = 0) uniform sampler2D u_motion;
layout(binding = 4) uniform sampler2D u_older;

layout(location = 0) out vec2 o_motion;

void main() {
  ivec2 own = ivec2(gl_FragCoord.xy);
  vec2 motion = texelFetch(u_motion, own, 0).rg;
  precise vec2 before = gl_FragCoord.xy - motion;
  ivec2 texel = ivec2(floor(before));
  // Where it leads out of the picture nothing more is known.
  bool isSeen = all(greaterThanEqual(before, vec2(0.0))) && all(lessThan(before, frame.sizePx));
  vec2 older = isSeen && isInRegion(own) ? texelFetch(u_older, texel, 0).rg : vec2(0.0);
  precise vec2 sum = motion + older;
  if (motion.x == kLargestHalf || older.x == kLargestHalf) sum = kNoPreviousPosition;
  o_motion = storedMotion(sum);
}
