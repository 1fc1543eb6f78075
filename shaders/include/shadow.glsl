// How much of the sun a surface sees. In: its place in the world, what the sun sees, kNoise. kShadows: kHardShadows
// compares with the map's four nearest texels; otherwise rays are traced in it: Unreal Engine's shadow map ray tracing,
// with samples denser near the surface. Out: from 0, in shadow, to 1.
#include "include/noise.glsl"
#include "shared/ShadowBlock.h"

layout(binding = 5) uniform sampler2D u_shadowMap;

const int kSamplesOfRay = 8;

/// A surface where it is shaded, as the map sees it: taken for a plane.
struct Receiver {
  vec3 place; // texels, depth
  vec2 slope; // depth by texel
};

Receiver receiverAt(vec3 world) {
  vec3 place = (shadow.mapFromWorld * vec4(world, 1.0)).xyz;
  vec3 across = cross(dFdxFine(place), dFdyFine(place));
  float facing = abs(across.z) > 1e-20 ? across.z : 1e-20;
  float steepest = 16.0 / max(shadow.lowest.w, 1e-6); // m by texel; steeper ones hardly get light
  return Receiver(place, clamp(-across.xy / facing, vec2(-steepest), vec2(steepest)));
}

/// How far before the receiver's plane the map's surface is at a texel, and how far before its place; m.
vec2 heights(Receiver receiver, ivec2 texel) {
  vec2 way = vec2(texel) + 0.5 - receiver.place.xy;
  float depth = texelFetch(u_shadowMap, clamp(texel, ivec2(0), ivec2(shadow.aside.w) - 1), 0).r;
  float before = depth - receiver.place.z;
  return vec2(before - dot(receiver.slope, way), before) * shadow.lowest.w;
}

float litShareOfTexels(Receiver receiver) {
  vec2 at = receiver.place.xy - 0.5;
  ivec2 first = ivec2(floor(at));
  vec2 share = at - vec2(first);
  vec4 lit;
  for (int i = 0; i < 4; ++i)
    lit[i] = heights(receiver, first + ivec2(i & 1, i >> 1)).x > shadow.highest.w ? 0.0 : 1.0;
  vec2 rows = mix(lit.xz, lit.yw, share.x);
  return mix(rows.x, rows.y, share.y);
}

/// Whether the ray meets something that goes `aside` in each meter towards the sun, at most `length_` m away.
bool isStopped(Receiver receiver, vec2 aside, float length_) {
  for (int i = 0; i < kSamplesOfRay; ++i) {
    float share = float(i) * (1.0 / float(kSamplesOfRay - 1));
    vec2 found = heights(receiver, ivec2(floor(receiver.place.xy + aside * (length_ * share * share))));
    if (found.x <= shadow.highest.w) continue;
    // Something is there; it stops the ray if it is there too where the ray is as high as it.
    vec2 met = heights(receiver, ivec2(floor(receiver.place.xy + aside * found.y)));
    if (met.x > shadow.highest.w) return true;
  }
  return false;
}

/// m until a ray to the sun leaves the box around all that casts shadows.
float lengthInBox(vec3 world) {
  vec3 side = mix(shadow.lowest.xyz, shadow.highest.xyz, greaterThan(shadow.toSun.xyz, vec3(0.0)));
  vec3 way = (side - world) / mix(shadow.toSun.xyz, vec3(1e-6), lessThan(abs(shadow.toSun.xyz), vec3(1e-6)));
  return max(min(min(way.x, way.y), way.z), 0.0);
}

float litShareOfRays(Receiver receiver, vec3 world) {
  int rays = int(shadow.aside.z);
  float length_ = lengthInBox(world);
  vec2 u = kNoise == kNoNoise ? vec2(rays == 1 ? 0.0 : 0.5, 0.0) : noisePair(ivec2(gl_FragCoord.xy), shadow.toSun.w);
  int seen = 0;
  for (int i = 0; i < rays; ++i) {
    float angle = 6.28318531 * (u.y + 0.61803398875 * float(i));
    float radius = sqrt((float(i) + u.x) / float(rays));
    vec2 aside = radius * vec2(cos(angle), sin(angle)) * shadow.aside.xy;
    if (!isStopped(receiver, aside, length_)) ++seen;
  }
  return float(seen) / float(rays);
}

float litShare(vec3 world) {
  Receiver receiver = receiverAt(world);
  vec2 place = receiver.place.xy;
  bool isBeside = min(place.x, place.y) < 0.0 || max(place.x, place.y) > shadow.aside.w;
  if (isBeside || receiver.place.z < 0.0) return 1.0; // or behind all that the map reaches
  return kShadows == kHardShadows ? litShareOfTexels(receiver) : litShareOfRays(receiver, world);
}
