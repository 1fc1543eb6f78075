// The last that happens to a shaded color before the resolve. In: scene-linear color, with what is blended over it.
// Out: the same, not negative; kClipped: no channel above 1 (manual 1.2); then with a noise that is one number for
// the three channels (20.1 to 20.4). kNoise, kTriangular: its form.
#include "include/noise.glsl"
#include "include/storage.glsl"
#include "shared/NoiseBlock.h"

layout(binding = 0) uniform sampler2D u_color;

layout(location = 0) out vec4 o_color;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  precise vec3 color = texelFetch(u_color, pixel, 0).rgb;
  if (kClipped) color = mix(color, vec3(1.0), greaterThan(color, vec3(1.0))); // NaN stays for storedColor()
  if (kNoise != kNoNoise) {
    vec2 u = noisePair(pixel, noise.terms.y);
    precise float added = noise.terms.x * (kTriangular ? u.x + u.y - 1.0 : u.x - 0.5);
    color += added;
  }
  o_color = storedColor(color);
}
