// Logarithms and powers with the same bits on every driver and CPU: log2, exp2 and pow of GLSL may differ in their last
// ones. Made of + − × ÷, floor and bits alone. Bounds of errors are relative; tests/unit/twin/PowersTest.cpp derives them.

#include "include/select.glsl"

/// log₂((1 + t)/(1 − t)), |t| ≤ 0.1716, within 4·10⁻⁷ of it: 2/ln 2 · (t + t³/3 + t⁵/5 + t⁷/7 + t⁹/9).
float log2OfRatio(float t) {
  precise float t2 = t * t;
  precise float inner = (((0.320598898 * t2 + 0.412198583) * t2 + 0.577078016) * t2 + 0.961796694) * t2 + 2.88539008;
  precise float result = t * inner;
  return result;
}

/// log₂ x of a positive normal x, within 4·10⁻⁷ of it: near 1 as well, where it is nearly 0.
float log2Of(float x) {
  int bits = floatBitsToInt(x);
  int exponent = (bits - 0x3F3504F3) >> 23; // x = m·2^exponent, m from √½ to √2
  float m = intBitsToFloat(bits - (exponent << 23));
  precise float t = (m - 1.0) / (m + 1.0);
  precise float result = float(exponent) + log2OfRatio(t);
  return result;
}

/// log₂(1 + x), x ≥ 0, within 6·10⁻⁷ of it: however small x is.
float log2OfOnePlus(float x) {
  precise float sum = 1.0 + x;
  precise float t = x / (2.0 + x);
  return mix(log2Of(sum), log2OfRatio(t), x < 0.41421354); // below √2 − 1
}

/// 2^x = whole · (1 + rest), |rest| < ½.
struct PowerOfTwo {
  float whole; // a power of two
  float rest;
};

/// x from −126 to 127; beyond, as there. Of x = whole number + f: Σ (f ln 2)ᵏ/k!, k from 1 to 7.
PowerOfTwo powerOfTwo(float x) {
  float within = minimum(maximum(x, -126.0), 127.0);
  precise float shifted = within + 0.5;
  float nearest = floor(shifted);
  precise float f = within - nearest;
  precise float inner = ((1.5252734e-5 * f + 1.5403530e-4) * f + 1.3333558e-3) * f + 9.6181291e-3;
  precise float outer = ((inner * f + 5.5504109e-2) * f + 0.24022651) * f + 0.69314718;
  precise float rest = f * outer;
  return PowerOfTwo(intBitsToFloat((int(nearest) + 127) << 23), rest);
}

/// 2^x within 2·10⁻⁷ of it; 0 below x = −126 and of NaN, 2¹²⁷ above 127.
float exp2Of(float x) {
  PowerOfTwo parts = powerOfTwo(x);
  precise float result = parts.whole * (1.0 + parts.rest);
  return mix(0.0, result, x >= -126.0);
}

/// 2^x − 1, as near: however small x is.
float exp2LessOne(float x) {
  PowerOfTwo parts = powerOfTwo(x);
  precise float result = parts.whole * parts.rest + (parts.whole - 1.0);
  return result;
}

/// x^e, 0 where x is below 10⁻³⁷ or NaN.
float power(float x, float e) {
  precise float exponent = e * log2Of(x);
  return mix(0.0, exp2Of(exponent), x >= 1e-37);
}
