// Luma, sane colors, and the way between scene-linear Rec. 709 and box space, the space of the neighborhood's
// box chosen by space.color and space.tone (catalogue §9, §15).

#include "include/select.glsl"

/// Largest finite half float: no color is brighter.
const float kBrightest = 65504.0;

float luma(vec3 c) {
  precise float result = (0.2126 * c.r + 0.7152 * c.g) + 0.0722 * c.b;
  return result;
}

/// NaN, Inf, negative and unstorable values are not.
bool isSane(float x) { return x >= 0.0 && x <= kBrightest; }

/// Channels that are not sane become 0.
vec3 sanitized(vec3 c) {
  return vec3(isSane(c.r) ? c.r : 0.0, isSane(c.g) ? c.g : 0.0, isSane(c.b) ? c.b : 0.0);
}

/// Scene-linear to box space: Reinhard by luma (15.2), then YCoCg (9.2), each if chosen.
vec3 toBox(vec3 color) {
  precise vec3 c = color;
  if (kSpaceTone == kSpaceTone_reinhardLuma) {
    precise float divisor = 1.0 + luma(c);
    c = c / divisor;
  }
  if (kSpaceColor == kSpaceColor_yCoCg) {
    precise float y = (0.25 * c.r + 0.5 * c.g) + 0.25 * c.b;
    precise float co = 0.5 * c.r - 0.5 * c.b;
    precise float cg = (-0.25 * c.r + 0.5 * c.g) - 0.25 * c.b;
    c = vec3(y, co, cg);
  }
  return c;
}

/// The inverse of toBox. May leave the gamut, so what comes out wants to be sanitized.
vec3 fromBox(vec3 box) {
  precise vec3 c = box;
  if (kSpaceColor == kSpaceColor_yCoCg) {
    precise float r = (c.x + c.y) - c.z;
    precise float g = c.x + c.z;
    precise float b = (c.x - c.y) - c.z;
    c = vec3(r, g, b);
  }
  if (kSpaceTone == kSpaceTone_reinhardLuma) {
    precise float difference = 1.0 - luma(c);
    precise float divisor = difference > 1e-5 ? difference : 1e-5; // luma 1 is infinitely bright
    c = c / divisor;
  }
  return c;
}
