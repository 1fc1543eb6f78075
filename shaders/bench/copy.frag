// The floor of the resolve's cost: reads what every resolve reads and writes what it writes. The sums keep
// the driver from leaving a read out.
layout(binding = 0) uniform sampler2D u_color;
layout(binding = 1) uniform sampler2D u_depth;
layout(binding = 2) uniform sampler2D u_motion;
layout(binding = 3) uniform sampler2D u_historyColor;
layout(binding = 4) uniform sampler2D u_historySurface;

layout(location = 0) out vec4 o_color;
layout(location = 1) out vec2 o_surface;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  ivec2 drawn = pixel * textureSize(u_color, 0) / textureSize(u_historyColor, 0); // inputs may be smaller
  vec4 color = texelFetch(u_color, drawn, 0) + texelFetch(u_historyColor, pixel, 0);
  vec2 motion = texelFetch(u_motion, drawn, 0).xy;
  o_color = color + motion.xyxy;
  o_surface = texelFetch(u_historySurface, pixel, 0).xy + texelFetch(u_depth, drawn, 0).x;
}
