// How much blending changed a pixel: five times the largest difference of the tone-mapped channels, at most 0.9
// (manual 21.5, FSR2). In: scene-linear colors. Out: the reactive mask; the responsive one stays.

layout(binding = 0) uniform sampler2D u_opaque;
layout(binding = 1) uniform sampler2D u_color; // with what was blended in

layout(location = 0) out vec2 o_mask;

vec3 toneMapped(vec3 color) { return color / (1.0 + max(color.r, max(color.g, color.b))); }

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 difference =
      abs(toneMapped(texelFetch(u_color, pixel, 0).rgb) - toneMapped(texelFetch(u_opaque, pixel, 0).rgb));
  o_mask = vec2(min(0.9, 5.0 * max(difference.r, max(difference.g, difference.b))), 0.0);
}
