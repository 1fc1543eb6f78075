// Compares what a pixel's dilated sample belongs to with what the history around its position was of (manual 12.2 to
// 12.5, 13.7). The best of the 3×3 texels around counts: as wide as the jitter, and alike on all sides. What is not compared, or not kept, agrees.

const bool kComparesObjects = kValidateObject || kValidateClass;
const bool kComparesMotion = kValidateVelocity != kValidateVelocity_none || kWeightVelocityChange;

struct GeometryMatch {
  float object; // number, 0 = sky or not kept
  bool isSameObject;
  bool isSameClass;
  float normalAgreement; // cosine
  float velocityChange;  // px a frame
};

/// Cosine of the angle between normals; the sky has none, and matches only itself.
float cosineOf(vec3 a, vec3 b) {
  precise float cosine = (a.x * b.x + a.y * b.y) + a.z * b.z;
  return a == vec3(0.0) && b == vec3(0.0) ? 1.0 : cosine;
}

/// How much motion changed (12.5); what had no previous position has not changed.
float changeOf(vec2 now, vec2 then) {
  precise vec2 difference = now - then;
  precise float ofLengths = abs(speedOf(now) - speedOf(then));
  if (now.x == kNoPreviousPosition || then.x == kNoPreviousPosition) return 0.0;
  return kValidateVelocity == kValidateVelocity_length ? ofLengths : speedOf(difference);
}

void compareObjects(ivec2 chosen, ivec2 middle, inout GeometryMatch match) {
  vec2 own = vec2(float(texelFetch(u_objectId, chosen, 0).r), texelAt(u_normal, chosen).w);
  keep_object(own);
  if (!keeps(kLayer_object)) return;
  match = GeometryMatch(historyAt(u_historyObject, middle).r, false, false, match.normalAgreement, match.velocityChange);
  for (int k = 0; k < 9; ++k) {
    vec2 stored = historyAt(u_historyObject, middle + ivec2(k % 3 - 1, k / 3 - 1)).rg;
    if (stored.r == own.r) {
      match.object = own.r;
      match.isSameObject = true;
    }
    if (stored.g == own.g) match.isSameClass = true;
  }
}

void compareNormals(ivec2 chosen, ivec2 middle, inout GeometryMatch match) {
  vec3 own = texelAt(u_normal, chosen).xyz;
  keep_normal(vec4(own, 0.0));
  if (!keeps(kLayer_normal)) return;
  match.normalAgreement = -1.0;
  for (int k = 0; k < 9; ++k) {
    float cosine = cosineOf(own, historyAt(u_historyNormal, middle + ivec2(k % 3 - 1, k / 3 - 1)).xyz);
    if (cosine > match.normalAgreement) match.normalAgreement = cosine;
  }
}

void compareMotion(vec2 own, ivec2 middle, inout GeometryMatch match) {
  if (!keeps(kLayer_motion)) return;
  for (int k = 0; k < 9; ++k) {
    float change = changeOf(own, historyAt(u_historyMotion, middle + ivec2(k % 3 - 1, k / 3 - 1)).rg);
    if (k == 0 || change < match.velocityChange) match.velocityChange = change;
  }
}

/// Of a render texel. `position`: where history is read, px.
GeometryMatch compareGeometry(ivec2 texel, DilatedMotion dilated, vec2 position) {
  GeometryMatch match = GeometryMatch(0.0, true, true, 1.0, 0.0);
  ivec2 chosen = texel + ivec2(dilated.offset);
  ivec2 middle = ivec2(floor(position));
  keep_motion(dilated.motion);
  if (kComparesObjects) compareObjects(chosen, middle, match);
  if (kValidateNormal) compareNormals(chosen, middle, match);
  if (kComparesMotion) compareMotion(dilated.motion, middle, match);
  expose_historyObjectId(match.object);
  expose_normalAgreement(match.normalAgreement);
  expose_velocityChange(match.velocityChange);
  return match;
}
