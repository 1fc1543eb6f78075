// Motion of the camera alone, from the depth buffer (catalogue §3.1, §3.2): what an engine has whose objects
// write no motion. Every surface is taken to stand still in the world.
#include "include/motion.glsl"

layout(binding = 0) uniform sampler2D u_depth;

layout(location = 0) out vec2 o_motion;
layout(location = 1) out float o_previousDepth;

void main() {
  float depth = texelFetch(u_depth, ivec2(gl_FragCoord.xy), 0).r;
  vec4 world = worldPosition(gl_FragCoord.xy, depth);
  float previousDepthView = -(frame.previousViewFromWorld * world).z / world.w;
  o_motion = cameraMotion(world);
  o_previousDepth = depth > 0.0 && previousDepthView > 0.0 ? previousDepthView : 0.0;
}
