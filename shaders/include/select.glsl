// Smallest, largest and bounded values by comparison: unlike min, max and clamp of GLSL, what they do with NaN
// is defined (a comparison with NaN is false). Precise, or a compiler may take them for min and max. mix() with a
// condition chooses, as ?: does; but ?: is a branch to Mesa until late, and a quarter of its time goes there.

float minimum(float a, float b) {
  precise float result = mix(b, a, a < b);
  return result;
}

float maximum(float a, float b) {
  precise float result = mix(b, a, a > b);
  return result;
}

vec3 minimum(vec3 a, vec3 b) {
  precise vec3 result = mix(b, a, lessThan(a, b));
  return result;
}

vec3 maximum(vec3 a, vec3 b) {
  precise vec3 result = mix(b, a, greaterThan(a, b));
  return result;
}

/// x within [0, 1]; NaN becomes 0.
float saturated(float x) {
  precise float result = mix(0.0, mix(1.0, x, x < 1.0), x > 0.0);
  return result;
}

/// x within [lo, hi].
vec3 clamped(vec3 x, vec3 lo, vec3 hi) { return minimum(maximum(x, lo), hi); }

/// Whether x lies in the box [lo, hi], walls included; never when a channel is NaN.
bool isInside(vec3 x, vec3 lo, vec3 hi) {
  return all(greaterThanEqual(x, lo)) && all(lessThanEqual(x, hi));
}
