// Shades a surface and writes all inputs of the resolve. Specialised by kTextures (bit s: the material has a
// texture in slot s), kMasked (discards where alpha is below the cutoff, or, kDithered, below a pattern), kBlended
// (premultiplies), kMask (0: none is drawn, 1: the material's, 2: and opacity), kLit, kBiased and kUnjittered (how
// textures are read), kPrintedMotion, kInstanced (as in mesh.vert), kDepthOnly (as it casts shadows), kShadows (how they
// fall on it), and the scene's numbers of lights:
// llvmpipe runs both sides of a branch, samples at full cost and reads blocks slowly by a variable index.
#include "include/brdf.glsl"
#include "include/motion.glsl"
#include "include/shadow.glsl"
#include "include/sky.glsl"
#include "shared/DrawBlock.h"
#include "shared/LightBlock.h"
#include "shared/MaterialBlock.h"

layout(binding = 0) uniform sampler2D u_baseColor;
layout(binding = 1) uniform sampler2D u_metallicRoughness;
layout(binding = 2) uniform sampler2D u_normal;
layout(binding = 3) uniform sampler2D u_occlusion;
layout(binding = 4) uniform sampler2D u_emissive;

in vec3 v_worldPosition;
in vec3 v_normal;
in vec4 v_tangent;
in vec4 v_uv;
in vec4 v_color;
in vec3 v_clip;
in vec3 v_previousClip;
in float v_previousDepthView;
flat in vec4 v_drawTerms; // DrawBlock::drawTerms, where one call draws many objects

layout(location = 0) out vec4 o_color;
layout(location = 1) out vec2 o_motion;
layout(location = 2) out vec4 o_normal;
layout(location = 3) out uint o_objectId;
layout(location = 4) out float o_previousDepth;
layout(location = 5) out vec2 o_mask; // reactive, responsive

bool hasTexture(int slot) { return (kTextures >> slot & 1) == 1; }

vec2 slotUv(int slot) {
  vec4 row = material.uvRows[2 * slot];
  vec3 uv = vec3(row.w > 0.5 ? v_uv.zw : v_uv.xy, 1.0);
  return vec2(dot(row.xyz, uv), dot(material.uvRows[2 * slot + 1].xyz, uv));
}

/// The texture of a slot. Unjittered, it is read where the pixel's center lies (manual 19.2); derivatives are those
/// of the original coordinates.
vec4 slotTexture(sampler2D map, int slot) {
  vec2 uv = slotUv(slot);
  if (!kUnjittered) return kBiased ? texture(map, uv, frame.textures.x) : texture(map, uv);
  vec2 alongX = dFdxFine(uv);
  vec2 alongY = dFdyFine(uv);
  float scale = kBiased ? frame.textures.y : 1.0;
  return textureGrad(map, uv + alongX * frame.jitterPx.x + alongY * frame.jitterPx.y, alongX * scale, alongY * scale);
}

/// Thresholds of an ordered 4×4 pattern; over sixteen frames each pixel has each of them once (manual 20.7).
float ditherThreshold() {
  const int kPattern[16] = int[](0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5);
  ivec2 cell = ivec2(gl_FragCoord.xy) & 3;
  int index = (kPattern[4 * cell.y + cell.x] + 7 * int(frame.textures.z)) & 15;
  return (float(index) + 0.5) / 16.0;
}

vec3 safeNormalize(vec3 value) { return value * inversesqrt(max(dot(value, value), 1e-20)); }

vec3 shadingNormal() {
  vec3 normal = safeNormalize(v_normal);
  if (hasTexture(2)) {
    vec3 bump = slotTexture(u_normal, 2).xyz * 2.0 - 1.0;
    bump.xy *= material.surface.z;
    vec3 tangent = safeNormalize(v_tangent.xyz);
    vec3 bitangent = cross(normal, tangent) * v_tangent.w;
    normal = safeNormalize(tangent * bump.x + bitangent * bump.y + normal * bump.z);
  }
  return gl_FrontFacing ? normal : -normal;
}

/// Irradiance of point or spot light `index` on a plane that faces it, and the direction to it.
vec3 nearLight(int index, out vec3 toLight) {
  vec4 terms = lighting.lightTerms[index];
  vec3 way = lighting.lightPosition[index].xyz - v_worldPosition;
  float distance2 = max(dot(way, way), 1e-8);
  float inverseDistance = inversesqrt(distance2);
  toLight = way * inverseDistance;
  float beyond = distance2 * terms.z;
  float window = clamp(1.0 - beyond * beyond, 0.0, 1.0);
  float cone = clamp(terms.y - dot(toLight, lighting.lightDirection[index].xyz) * terms.x, 0.0, 1.0);
  return lighting.lightColor[index].rgb * (inverseDistance * inverseDistance * window * cone * cone);
}

/// Radiance of all punctual lights, directional ones first.
vec3 lightRadiance(Surface surface) {
  Reflection sum = Reflection(vec3(0.0), vec3(0.0), vec3(0.0));
  float seen = kShadows == kNoShadows ? 1.0 : litShare(v_worldPosition); // of the first one
  for (int index = 0; index < kDirectionalLights; ++index)
    addLight(sum, surface, lighting.lightColor[index].rgb * (index == 0 ? seen : 1.0), -lighting.lightDirection[index].xyz);
  for (int index = kDirectionalLights; index < kDirectionalLights + kNearLights; ++index) {
    vec3 toLight;
    vec3 irradiance = nearLight(index, toLight);
    addLight(sum, surface, irradiance, toLight);
  }
  return reflectedRadiance(sum, surface);
}

vec3 litColor(vec3 baseColor, vec3 normal) {
  float metallic = material.surface.x;
  float roughness = material.surface.y;
  float occlusion = 1.0;
  vec3 emissive = material.emissive.rgb;
  if (hasTexture(1)) {
    vec2 metallicRoughness = slotTexture(u_metallicRoughness, 1).bg;
    metallic *= metallicRoughness.x;
    roughness *= metallicRoughness.y;
  }
  if (hasTexture(3)) occlusion = 1.0 + material.surface.w * (slotTexture(u_occlusion, 3).r - 1.0);
  if (hasTexture(4)) emissive *= slotTexture(u_emissive, 4).rgb;
  vec3 forward = -vec3(frame.viewFromWorld[0].z, frame.viewFromWorld[1].z, frame.viewFromWorld[2].z);
  vec3 toCamera = frame.cameraPosition.w > 0.5 ? -forward : safeNormalize(frame.cameraPosition.xyz - v_worldPosition);
  Surface surface = makeSurface(baseColor, metallic, roughness, normal, toCamera);

  vec3 mirrored = reflect(-toCamera, normal);
  vec3 environment = skyGradient(reflect(-toCamera, normal).y, surface.roughness);
  vec3 ambient = surface.diffuse * skyAmbient(normal) + environmentReflectance(surface) * environment;
  return ambient * occlusion + lightRadiance(surface) + emissive;
}

void main() {
  vec4 baseColor = material.baseColor * v_color;
  if (hasTexture(0)) baseColor *= slotTexture(u_baseColor, 0);
  if (kMasked) {
    if (baseColor.a < (kDithered ? ditherThreshold() : material.emissive.w)) discard;
  }
  if (kBlended) {
    if (!(baseColor.a > 0.0)) discard;
  }
  if (kDepthOnly) return;
  vec3 normal = shadingNormal();
  o_color = storedColor(kLit ? litColor(baseColor.rgb, normal) : baseColor.rgb);
  if (kBlended) {
    float opacity = min(baseColor.a, 1.0);
    o_color = vec4(o_color.rgb * opacity, opacity);
  }
  vec4 drawTerms = kInstanced ? v_drawTerms : oneDraw.drawTerms;
  if (kMask > 0) o_mask = vec2(kMask == 2 ? min(baseColor.a, 1.0) : 0.0, drawTerms.z);
  o_motion = kPrintedMotion ? printedMotion(v_clip, v_previousClip) : motionFromClip(v_clip, v_previousClip);
  o_normal = vec4(normal, drawTerms.w);
  o_objectId = uint(drawTerms.x + 0.5);
  o_previousDepth = v_previousDepthView > 0.0 ? v_previousDepthView : 0.0;
}
