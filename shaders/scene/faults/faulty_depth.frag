// Depth with faults. In: reversed device depth, 0 = sky. Out: what is taken for it, and what is made of view depth in
// the previous frame by a near plane that is wrong.
#include "include/storage.glsl"
#include "scene/faults/region.glsl"

layout(binding = 0) uniform sampler2D u_previousDepth; // view depth, m

layout(location = 0) out float o_previousDepth;

// DepthFault.
const int kReversed = 1;
const int kLinear = 2;
const float kUnit = 100.0; // m, of linear depth

/// View depth in m; depth 0 is the sky.
float viewDepthOf(float depth) {
  precise float result =
      (depth * frame.depthTerms.x - frame.depthTerms.y) / (depth * frame.depthTerms.z - frame.depthTerms.w);
  return result;
}

float faulty(float depth) {
  int form = int(fault.colorTerms.w);
  if (form == kReversed) return 1.0 - depth;
  if (form == kLinear) return depth == 0.0 ? 1.0 : min(viewDepthOf(depth) / kUnit, 1.0);
  return depth;
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  int side = fault.texels.z;
  ivec2 from = min(texel / side * side + side / 2, textureSize(u_depth, 0) - 1);
  float depth = texelFetch(u_depth, texel, 0).r;
  gl_FragDepth = isInRegion(texel) ? faulty(texelFetch(u_depth, from, 0).r) : depth;
  o_previousDepth = texelFetch(u_previousDepth, texel, 0).r * fault.colorTerms.z;
}
