// Light and opacity of fog before each surface, marched in steps that are the same for all rays (source 001,
// "improving banding"). In: depth, cones. Out: scattered light, opacity; with kFogHistory also the mean of the frames
// before. kNoise: where in its step a sample lies; kExact: the integral itself instead.
#include "include/fog_cone.glsl"
#include "include/motion.glsl"
#include "include/noise.glsl"
#include "include/powers.glsl"

layout(binding = 0) uniform sampler2D u_depth;

layout(location = 0) out vec4 o_fog;
layout(location = 1) out vec4 o_before;

/// What came together so far.
struct March {
  vec3 light;
  float transmittance;
};

/// Transmittance of fog of optical depth x.
float transmitted(float x) { return exp2Of(-1.44269504 * x); }

Ray rayHere(float depth) {
  vec4 far = worldPosition(gl_FragCoord.xy, 0.0);
  vec3 forward = -vec3(frame.viewFromWorld[0].z, frame.viewFromWorld[1].z, frame.viewFromWorld[2].z);
  bool isParallel = frame.cameraPosition.w > 0.5;
  Ray ray = Ray(frame.cameraPosition.xyz, isParallel ? forward : normalize(far.xyz), kEndless);
  if (isParallel) { // from the plane through the camera
    vec3 aside = far.xyz / far.w - frame.cameraPosition.xyz;
    ray.origin += aside - dot(aside, forward) * forward;
  }
  if (depth > 0.0) {
    vec4 world = worldPosition(gl_FragCoord.xy, depth);
    ray.end = dot(world.xyz / world.w - ray.origin, ray.direction);
  }
  return ray;
}

/// A sample lies in a cone between where the ray enters it and leaves it.
March marched(Stretch cones[kMaxFogCones], float shift) {
  March march = March(vec3(0.0), 1.0);
  float first = kEndless, last = 0.0;
  for (int i = 0; i < fog.counts.x; ++i) {
    if (cones[i].first == cones[i].last) continue;
    first = min(first, cones[i].first);
    last = max(last, cones[i].last);
  }
  if (last == 0.0) return march;
  float rest = 1.0 / fog.march.y; // steps before the first cone find nothing
  int step_ = max(int((first - fog.march.x) * rest - shift) - 1, 0);
  for (; step_ < fog.counts.z; ++step_) {
    precise float t = fog.march.x + (float(step_) + shift) * fog.march.y;
    if (t >= last) break;
    float density = 0.0;
    vec3 light = vec3(0.0);
    for (int i = 0; i < fog.counts.x; ++i) {
      bool isInside = t >= cones[i].first && t < cones[i].last;
      density += isInside ? cones[i].density : 0.0;
      light += isInside ? cones[i].density * (cones[i].light + t * cones[i].change) : vec3(0.0);
    }
    if (density == 0.0) continue;
    float passed = transmitted(density * fog.march.y);
    march.light += march.transmittance * (1.0 - passed) / density * light;
    march.transmittance *= passed;
  }
  return march;
}

/// From one end of a cone to the next there is the same fog, whose light is linear: ∫ σ(a + bt)exp(−σt) dt.
March integrated(Stretch cones[kMaxFogCones]) {
  March march = March(vec3(0.0), 1.0);
  float t = -1.0;
  for (int part = 0; part < 2 * kMaxFogCones; ++part) {
    float next = kEndless;
    for (int i = 0; i < fog.counts.x; ++i) {
      if (cones[i].first == cones[i].last) continue;
      if (cones[i].first > t) next = min(next, cones[i].first);
      if (cones[i].last > t) next = min(next, cones[i].last);
    }
    if (next == kEndless) break;
    float density = 0.0;
    vec3 light = vec3(0.0), change = vec3(0.0);
    for (int i = 0; i < fog.counts.x; ++i) {
      if (cones[i].first > t || cones[i].last < next) continue;
      density += cones[i].density;
      light += cones[i].density * (cones[i].light + t * cones[i].change);
      change += cones[i].density * cones[i].change;
    }
    if (density > 0.0) {
      float thickness = next - t;
      float x = density * thickness;
      float passed = transmitted(x);
      float curve = x < 1e-3 ? 0.5 * x : (1.0 - passed) / x - passed;
      march.light += march.transmittance / density * (light * (1.0 - passed) + change * (thickness * curve));
      march.transmittance *= passed;
    }
    t = next;
  }
  return march;
}

/// Of this frame's rays, with cones and noise of the frame `age` frames ago.
vec4 fogOf(Ray ray, int age) {
  Stretch cones[kMaxFogCones];
  for (int i = 0; i < fog.counts.x; ++i) cones[i] = stretchOf(ray, i, age);
  March march;
  if (kExact)
    march = integrated(cones);
  else {
    float number = fog.apex[age * kMaxFogCones].w;
    march = marched(cones, kNoise == kNoNoise ? 0.5 : noisePair(ivec2(gl_FragCoord.xy), number).x);
  }
  return vec4(march.light, 1.0 - march.transmittance);
}

vec4 stored(vec4 value) {
  return frame.storage.x > 0.5 ? vec4(roundedToHalf(value.rgb), roundedToHalf(value.aaa).x) : value;
}

void main() {
  Ray ray = rayHere(texelFetch(u_depth, ivec2(gl_FragCoord.xy), 0).r);
  o_fog = stored(fogOf(ray, 0));
  if (!kFogHistory) return;
  vec4 sum = vec4(0.0);
  for (int age = 1; age < fog.counts.y; ++age) sum += fogOf(ray, age);
  o_before = stored(sum / float(max(fog.counts.y - 1, 1)));
}
