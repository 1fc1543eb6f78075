// A vertex, in this frame and in the previous one. Besides by what deforms it (scene/deform.glsl), specialised by
// kSteady (drawn without jitter), kPrintedJitter (another projection than the translation), kMovingUv and kInstanced
// (one call draws many objects: llvmpipe reads the block of one faster).
#include "shared/DrawBlock.h"
#include "shared/FrameBlock.h"
#include "shared/MaterialBlock.h"
#include "scene/deform.glsl"

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec4 a_tangent;
layout(location = 3) in vec2 a_uv0;
layout(location = 4) in vec2 a_uv1;
layout(location = 5) in vec4 a_color;

out vec3 v_worldPosition;
out vec3 v_normal;
out vec4 v_tangent; // w: sign of the bitangent
out vec4 v_uv;      // sets 0 and 1
out vec4 v_color;
out vec3 v_clip; // x, y, w, unjittered
out vec3 v_previousClip;
out float v_previousDepthView;
flat out vec4 v_drawTerms;

void main() {
  if (kInstanced) draw = instances[gl_InstanceID];
  if (!kInstanced) draw = oneDraw;
  Deformed now = deformedVertex(a_position, a_normal, a_tangent.xyz, a_uv1.y, draw.deform.x, draw.deform.y,
                                draw.moments.x, 0.0);
  Deformed then = deformedVertex(a_position, a_normal, a_tangent.xyz, a_uv1.y, draw.deform.x + draw.deformCounts.z,
                                 draw.deform.y + draw.deformCounts.w, draw.moments.y, draw.moments.z);
  vec4 position = vec4(now.position, 1.0);
  vec4 previousPosition = vec4(then.position, 1.0);
  precise vec4 clip = draw.clipFromModel * position;
  precise vec4 previousClip = draw.previousClipFromModel * previousPosition;
  v_clip = clip.xyw;
  v_previousClip = previousClip.xyw;
  v_previousDepthView = dot(draw.previousDepthRow, previousPosition);

  v_worldPosition = (draw.worldFromModel * position).xyz;
  v_normal = mat3(draw.normalFromModel) * now.normal;
  v_tangent = vec4(mat3(draw.worldFromModel) * now.tangent, a_tangent.w * draw.drawTerms.y);
  v_uv = vec4(kMovingUv ? a_uv0 * draw.uvCell.xy + draw.uvCell.zw : a_uv0, a_uv1);
  v_color = a_color;
  if (kInstanced) v_drawTerms = draw.drawTerms;

  // The jitter of T(2jx/W, −2jy/H)·P; z and w stay as they are.
  vec2 jitterNdc = kSteady ? vec2(0.0) : vec2(2.0, -2.0) * (frame.jitterPx / frame.sizePx);
  vec2 shift = kPrintedJitter ? frame.printedJitter.xy * clip.w + frame.printedJitter.zw * clip.z : jitterNdc * clip.w;
  gl_Position = vec4(clip.xy + shift, clip.zw);
  gl_PointSize = 3.0; // glTF says nothing of it; one pixel is hard to see
}
