// Color with faults. In: scene-linear color, and that of the sky with another jitter. Out: brighter where the faults
// are, with an interface drawn over it, and one texel that is no number.
#include "include/storage.glsl"
#include "scene/faults/region.glsl"

layout(binding = 0) uniform sampler2D u_color;
layout(binding = 4) uniform sampler2D u_sky; // the whole picture again, drawn for its sky …
layout(binding = 5) uniform sampler2D u_skyDepth; // … which is where nothing is in it either

layout(location = 0) out vec4 o_color;

const float kBar = 24.0;  // px, height of the bars at top and bottom
const float kGrid = 8.0;  // px from line to line of the grid in them
const vec3 kInk = vec3(1.0);
const vec3 kPaper = vec3(0.05);

/// How much of [at − ½, at + ½] lies in [from, to].
float covered(float at, float from, float to) { return clamp(min(at + 0.5, to) - max(at - 0.5, from), 0.0, 1.0); }

/// How much of a px around `at` is a line of the grid: one px in kGrid.
float lineShare(float at) {
  precise float place = mod(at, kGrid);
  return covered(place, 0.0, 1.0) + covered(place - kGrid, 0.0, 1.0);
}

/// The interface over a color; `at`: where it is looked at, px.
vec3 underInterface(vec3 color, vec2 at) {
  float bars = covered(at.y, 0.0, kBar) + covered(at.y, frame.sizePx.y - kBar, frame.sizePx.y);
  float x = lineShare(at.x);
  float y = lineShare(at.y);
  vec3 drawn = mix(kPaper, kInk, x + y - x * y);
  return mix(color, drawn, clamp(bars, 0.0, 1.0));
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 color = texelFetch(u_color, texel, 0);
  bool isSky = texelFetch(u_depth, texel, 0).r == 0.0 && texelFetch(u_skyDepth, texel, 0).r == 0.0;
  if (kSkyAlone && isSky) color = texelFetch(u_sky, texel, 0);
  if (fault.colorTerms.x != 1.0 && isInRegion(texel)) color = storedColor(color.rgb * fault.colorTerms.x);
  if (fault.colorTerms.y > 0.0) {
    bool isJittered = fault.colorTerms.y > 1.5; // InterfaceFault
    precise vec2 at = gl_FragCoord.xy - (isJittered ? fault.jitter.xy : vec2(0.0));
    color = storedColor(underInterface(color.rgb, at));
  }
  if (texel == fault.place.zw) color.rgb = vec3(uintBitsToFloat(0x7FC00000u));
  o_color = color;
}
