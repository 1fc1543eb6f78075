// Luma, sane colors, and the way between scene-linear Rec. 709 and box space, the space of the neighborhood's
// box chosen by space.color and space.tone (manual §9, §15).

#include "include/select.glsl"
#include "include/tone_curves.glsl"

/// Largest finite half float: no color is brighter.
const float kBrightest = 65504.0;

float luma(vec3 c) {
  precise float result = (0.2126 * c.r + 0.7152 * c.g) + 0.0722 * c.b;
  return result;
}

/// Luma that colors are weighed by, in every stage (15.1).
float weightLuma(vec3 c) {
  precise float y = (0.25 * c.r + 0.5 * c.g) + 0.25 * c.b;
  return kSpaceLuma == kSpaceLuma_yCoCg ? y : luma(c);
}

/// Channels that are not sane, which are NaN, Inf, negative or cannot be stored, become those of another color.
vec3 saneOr(vec3 other, vec3 c) {
  return mix(mix(other, c, greaterThanEqual(c, vec3(0.0))), other, greaterThan(c, vec3(kBrightest)));
}

vec3 sanitized(vec3 c) { return saneOr(vec3(0.0), c); }

/// What a computed color becomes: negative values and NaN 0, too bright ones the brightest that can be stored.
vec3 storable(vec3 c) { return clamped(c, vec3(0.0), vec3(kBrightest)); }

const bool kIsRgb = kSpaceColor == kSpaceColor_rgb;
const bool kIsYCoCgAsPrinted = kSpaceColor == kSpaceColor_yCoCgAsPrinted;
const bool kIsYCoCg = kSpaceColor == kSpaceColor_yCoCg || kIsYCoCgAsPrinted;

float largestChannel(vec3 c) { return maximum(maximum(c.r, c.g), c.b); }

/// Divisor of the inverse of c/(1 + x): brightness 1 is infinitely bright.
float inverseDivisor(float brightness) {
  precise float difference = 1.0 - brightness;
  return maximum(difference, 1e-5);
}

/// Each channel by itself (15.3).
vec3 reinhardChannel(vec3 c) {
  precise vec3 result = c / (1.0 + c);
  return result;
}

vec3 inverseReinhardChannel(vec3 c) {
  precise vec3 result = c / vec3(inverseDivisor(c.r), inverseDivisor(c.g), inverseDivisor(c.b));
  return result;
}

/// By the largest channel (15.4).
vec3 compressMax(vec3 c) {
  precise float divisor = 1.0 + largestChannel(c);
  precise vec3 result = c / divisor;
  return result;
}

vec3 inverseCompressMax(vec3 c) {
  precise vec3 result = c / inverseDivisor(largestChannel(c));
  return result;
}

vec3 pqChannel(vec3 c) { return vec3(pq(c.r), pq(c.g), pq(c.b)); }

vec3 inversePqChannel(vec3 c) { return vec3(inversePq(c.r), inversePq(c.g), inversePq(c.b)); }

vec3 logarithmChannel(vec3 c) { return vec3(logarithm(c.r), logarithm(c.g), logarithm(c.b)); }

vec3 inverseLogarithmChannel(vec3 c) {
  return vec3(inverseLogarithm(c.r), inverseLogarithm(c.g), inverseLogarithm(c.b));
}

vec3 gammaChannel(vec3 c) { return vec3(gammaEncoded(c.r), gammaEncoded(c.g), gammaEncoded(c.b)); }

vec3 inverseGammaChannel(vec3 c) { return vec3(gammaDecoded(c.r), gammaDecoded(c.g), gammaDecoded(c.b)); }

/// The chosen axes (manual §9).
vec3 toAxes(vec3 color) {
  precise vec3 c = color;
  if (kIsYCoCg) {
    precise float y = (0.25 * c.r + 0.5 * c.g) + 0.25 * c.b;
    precise float co = 0.5 * c.r - 0.5 * c.b;
    precise float cg = (-0.25 * c.r + 0.5 * c.g) - 0.25 * c.b;
    return vec3(y, co, cg);
  }
  if (kSpaceColor == kSpaceColor_yCoCgLifting) {
    precise float co = c.r - c.b;
    precise float t = c.b + 0.5 * co;
    precise float cg = c.g - t;
    precise float y = t + 0.5 * cg;
    return vec3(y, co, cg);
  }
  if (kSpaceColor == kSpaceColor_yCbCr) {
    precise float y = luma(c);
    precise float cb = (c.b - y) / 1.8556;
    precise float cr = (c.r - y) / 1.5748;
    return vec3(y, cb, cr);
  }
  return c;
}

vec3 fromAxes(vec3 axes) {
  precise vec3 c = axes;
  if (kIsYCoCg) {
    precise float r = (c.x + c.y) - c.z;
    precise float g = c.x + c.z;
    precise float b = (c.x - c.y) - c.z;
    if (kIsYCoCgAsPrinted) return vec3(saturated(r), saturated(g), saturated(b)); // manual §26, D7
    return vec3(r, g, b);
  }
  if (kSpaceColor == kSpaceColor_yCoCgLifting) {
    precise float t = c.x - 0.5 * c.z;
    precise float g = c.z + t;
    precise float b = t - 0.5 * c.y;
    precise float r = b + c.y;
    return vec3(r, g, b);
  }
  if (kSpaceColor == kSpaceColor_yCbCr) {
    precise float r = c.x + 1.5748 * c.z;
    precise float b = c.x + 1.8556 * c.y;
    precise float g = ((c.x - 0.2126 * r) - 0.0722 * b) / 0.7152;
    return vec3(r, g, b);
  }
  return c;
}

/// Luma of a color in box space.
float boxLuma(vec3 box) { return kIsRgb ? luma(box) : box.x; }

/// Scene-linear to box space: compressed (manual §15), then in the chosen axes, each if chosen.
vec3 toBox(vec3 color) {
  precise vec3 c = color;
  if (kSpaceTone == kSpaceTone_reinhardLuma) {
    precise float divisor = 1.0 + luma(c);
    c = c / divisor;
  }
  if (kSpaceTone == kSpaceTone_reinhardChannel) c = reinhardChannel(c);
  if (kSpaceTone == kSpaceTone_maxChannel) c = compressMax(c);
  if (kSpaceTone == kSpaceTone_pq) c = pqChannel(c);
  if (kSpaceTone == kSpaceTone_logarithm) c = logarithmChannel(c);
  if (kSpaceTone == kSpaceTone_gamma) c = gammaChannel(c);
  return toAxes(c);
}

/// The inverse of toBox. May leave the gamut, so what comes out wants to be made storable.
vec3 fromBox(vec3 box) {
  precise vec3 c = fromAxes(box);
  if (kSpaceTone == kSpaceTone_reinhardLuma) c = c / inverseDivisor(luma(c));
  if (kSpaceTone == kSpaceTone_reinhardChannel) c = inverseReinhardChannel(c);
  if (kSpaceTone == kSpaceTone_maxChannel) c = inverseCompressMax(c);
  if (kSpaceTone == kSpaceTone_pq) c = inversePqChannel(c);
  if (kSpaceTone == kSpaceTone_logarithm) c = inverseLogarithmChannel(c);
  if (kSpaceTone == kSpaceTone_gamma) c = inverseGammaChannel(c);
  return c;
}
