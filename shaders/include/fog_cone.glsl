// Where a ray runs through a cone of fog, and how much light the fog has there. Distances along the ray in m.
#include "shared/FogBlock.h"

const float kEndless = 1e30;

struct Ray {
  vec3 origin, direction; // normalized
  float end;              // of the surface that is seen
};

/// A cone along a ray: it holds fog from `first` to `last`, which gives `light` + t·`change`.
struct Stretch {
  float first, last; // equal: none
  float density;
  vec3 light, change;
};

/// Where |p − (p·a)a| ≤ r(p·a), with ends of the cone's length left to the caller: A t² + 2B t + C ≤ 0.
vec2 sideOf(float squared, float middle, float constant, float along) {
  float a = abs(squared) < 1e-6 ? 1e-6 : squared;
  precise float discriminant = middle * middle - a * constant;
  // Inside for ever: the ray runs steeper than the side.
  if (discriminant < 0.0) return a < 0.0 ? vec2(-kEndless, kEndless) : vec2(kEndless, -kEndless);
  float root = sqrt(discriminant);
  float low = (-middle - root) / a, high = (-middle + root) / a;
  if (a > 0.0) return vec2(low, high);
  // Two of them, one in the cone's mirror image: low and high change places.
  return along > 0.0 ? vec2(low, kEndless) : vec2(-kEndless, high);
}

/// The cone `index` of the frame `age` frames ago, along the ray up to its end.
Stretch stretchOf(Ray ray, int index, int age) {
  vec3 apex = fog.apex[age * kMaxFogCones + index].xyz;
  vec3 axis = fog.axis[age * kMaxFogCones + index].xyz;
  vec4 shape = fog.shape[index];
  vec3 from = ray.origin - apex;
  precise float start = dot(from, axis);
  precise float along = dot(ray.direction, axis);
  precise float radius = shape.x + shape.y * start; // of the cone where the ray starts; it gains `gain` a meter
  precise float gain = shape.y * along;
  precise float squared = 1.0 - along * along - gain * gain;
  precise float middle = dot(from, ray.direction) - start * along - gain * radius;
  precise float constant = dot(from, from) - start * start - radius * radius;
  vec2 side = sideOf(squared, middle, constant, along);
  float slope = abs(along) < 1e-6 ? 1e-6 : along;
  float small = -start / slope, large = (shape.w - start) / slope;
  float first = max(max(side.x, min(small, large)), 0.0);
  float last = min(min(side.y, max(small, large)), ray.end);
  vec4 light = fog.light[index];
  return Stretch(first, max(first, last), light.w, light.rgb * (1.0 - shape.z * start), light.rgb * (-shape.z * along));
}
