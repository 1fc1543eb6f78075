// Smallest, largest and bounded values by comparison: unlike min, max and clamp of GLSL, what they do with NaN
// is defined (a comparison with NaN is false).

float lesser(float a, float b) { return a < b ? a : b; }
float greater(float a, float b) { return a > b ? a : b; }

/// x within [0, 1]; NaN becomes 0.
float saturated(float x) { return x > 0.0 ? (x < 1.0 ? x : 1.0) : 0.0; }

vec3 lesser(vec3 a, vec3 b) { return vec3(lesser(a.x, b.x), lesser(a.y, b.y), lesser(a.z, b.z)); }
vec3 greater(vec3 a, vec3 b) { return vec3(greater(a.x, b.x), greater(a.y, b.y), greater(a.z, b.z)); }

/// x within [lo, hi].
vec3 bounded(vec3 x, vec3 lo, vec3 hi) { return lesser(greater(x, lo), hi); }

/// Whether x lies in the box [lo, hi], walls included; never when a channel is NaN.
bool isInside(vec3 x, vec3 lo, vec3 hi) {
  return all(greaterThanEqual(x, lo)) && all(lessThanEqual(x, hi));
}
