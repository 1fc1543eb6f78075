// The sky behind everything: color and motion by direction; no normal, object or depth.
#include "include/motion.glsl"
#include "include/sky.glsl"

layout(location = 0) out vec4 o_color;
layout(location = 1) out vec2 o_motion;
layout(location = 2) out vec4 o_normal;
layout(location = 3) out uint o_objectId;
layout(location = 4) out float o_previousDepth;

void main() {
  vec4 world = worldPosition(gl_FragCoord.xy, 0.0);
  // Orthographic rays are parallel: all of them see one point of the sky.
  vec3 forward = -vec3(frame.viewFromWorld[0].z, frame.viewFromWorld[1].z, frame.viewFromWorld[2].z);
  vec3 direction = frame.cameraPosition.w > 0.5 ? forward : normalize(world.xyz);
  o_color = storedColor(skyRadiance(direction));
  o_motion = cameraMotion(world);
  o_normal = vec4(0.0);
  o_objectId = 0u;
  o_previousDepth = 0.0;
}
