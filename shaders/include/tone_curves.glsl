// Curves that compress a channel, and their inverses (manual §15). In: scene-linear, 0 to 65504; or what the curve
// made of that, and whatever a box or a mix makes of those.

#include "include/powers.glsl"

/// SMPTE ST 2084 with 10000 as 1 (15.5): ((c₁ + c₂r)/(1 + c₃r))^m₂, r = (c/10000)^m₁. Goes on beyond 1 instead of
/// ending there: 65504 becomes 1.19 and comes back. The fraction is near 1 and its power large, so that its last bit
/// would show: by c₁ = 1 + c₃ − c₂ it is (1 + t)/(1 − t), or 1 + less, without a difference of near numbers.
float pq(float c) {
  precise float part = c / 10000.0;
  float root = power(part, 0.1593017578125); // m₁ = 2610/16384
  // (c₂ − c₃)(r − 1)/(1 + c₁ + (c₂ + c₃)r)
  precise float t = (0.1640625 * (root - 1.0)) / (1.8359375 + 37.5390625 * root);
  precise float exponent = 78.84375 * log2OfRatio(t); // m₂ = 128 · 2523/4096
  return exp2Of(exponent);
}

float inversePq(float y) {
  precise float exponent = 0.0126833133 * log2Of(maximum(y, 1e-37)); // 1/m₂
  float less = exp2LessOne(exponent);                                // the fraction less 1
  precise float above = 0.1640625 + less;
  precise float below = 0.1640625 - 18.6875 * less; // 0 at infinite brightness
  precise float root = maximum(above, 0.0) / maximum(below, 1e-5);
  precise float result = 10000.0 * power(root, 6.27739477); // 1/m₁
  return result;
}

/// log₂(1 + c) (15.7).
float logarithm(float c) { return log2OfOnePlus(c); }

float inverseLogarithm(float y) { return exp2LessOne(y); }

/// The curve of sRGB (9.4), IEC 61966-2-1, which goes on beyond 1.
float gammaEncoded(float c) {
  precise float dark = 12.92 * c;
  precise float bright = 1.055 * power(c, 0.4166666667) - 0.055; // 1/2.4
  return mix(dark, bright, c > 0.0031308);
}

/// Of what lies below 0 in proportion: a box in other axes may.
float gammaDecoded(float y) {
  precise float dark = y / 12.92;
  precise float base = (y + 0.055) / 1.055;
  return mix(dark, power(base, 2.4), y > 0.04045);
}

/// c(1 + c/W²)/(1 + c): Reinhard's with a white that becomes 1 (15.6).
vec3 whitePoint(vec3 c, float white) {
  precise float squared = white * white;
  precise vec3 result = (c * (1.0 + c / squared)) / (1.0 + c);
  return result;
}

/// The root of c²/W² + (1 − y)c − y = 0 that is not negative, in that of its two forms without a difference of near
/// numbers.
vec3 inverseWhitePoint(vec3 y, float white) {
  precise float squared = white * white;
  precise vec3 rest = 1.0 - y;
  precise vec3 discriminant = rest * rest + (4.0 * y) / squared;
  precise vec3 root = sqrt(discriminant);
  precise vec3 dark = (2.0 * y) / (rest + root);
  precise vec3 bright = ((root - rest) * squared) / 2.0;
  return mix(bright, dark, lessThanEqual(y, vec3(1.0)));
}
