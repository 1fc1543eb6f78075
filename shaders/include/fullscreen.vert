// One triangle that covers the whole target, at depth 0: behind everything where depth is reversed. Drawn by
// RenderPass::drawFullscreen, without attributes.

out gl_PerVertex { // written out: one stage for all programs, linked alone
  vec4 gl_Position;
};

void main() {
  vec2 corner = vec2((gl_VertexID & 1) * 4 - 1, (gl_VertexID >> 1) * 4 - 1);
  gl_Position = vec4(corner, 0.0, 1.0);
}
