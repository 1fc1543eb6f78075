// Order of operations as in the definition of the resolve.
#include "core/taa/twin/ToneCurves.h"

#include "core/taa/twin/Instances.h"
#include "core/taa/twin/Powers.h"

#include <cmath>

namespace taa::twin {
namespace {

// As SMPTE ST 2084 writes them.
constexpr float kM1 = 2610.0f / 16384.0f;
constexpr float kM2 = 2523.0f / 4096.0f * 128.0f;
constexpr float kC1 = 3424.0f / 4096.0f;
constexpr float kC2 = 2413.0f / 4096.0f * 32.0f;
constexpr float kC3 = 2392.0f / 4096.0f * 32.0f;
constexpr float kBrightest = 10000.0f;
static_assert(kC1 == 1.0f + kC3 - kC2);
/// Less than what black becomes, and a normal float.
constexpr float kDarkest = 1e-37f;
/// Where the curve would be infinitely bright, it is this far from it.
constexpr float kMinDivisor = 1e-5f;

} // namespace

// The fraction (c₁ + c₂r)/(1 + c₃r) is near 1 and its power large, so that its last bit would show: c₁ is
// 1 + c₃ − c₂, with which it is (1 + t)/(1 − t), or 1 + less, without a difference of near numbers.

template <typename Real>
Real pq(Real c) {
  const Real root = power(c / kBrightest, kM1);
  const Real t = ((kC2 - kC3) * (root - 1.0f)) / ((1.0f + kC1) + (kC2 + kC3) * root);
  return exp2Of(kM2 * log2OfRatio(t));
}

template <typename Real>
Real inversePq(Real y) {
  const Real less = exp2LessOne((1.0f / kM2) * log2Of(y > kDarkest ? y : kDarkest));
  const Real above = (1.0f - kC1) + less, below = (kC2 - kC3) - kC3 * less;
  const Real root = (above > 0.0f ? above : 0.0f) / (below > kMinDivisor ? below : kMinDivisor);
  return kBrightest * power(root, 1.0f / kM1);
}

template <typename Real>
Real logarithm(Real c) {
  return log2OfOnePlus(c);
}

template <typename Real>
Real inverseLogarithm(Real y) {
  return exp2LessOne(y);
}

template <typename Real>
Real gammaEncoded(Real c) {
  return c > 0.0031308f ? 1.055f * power(c, 1.0f / 2.4f) - 0.055f : 12.92f * c;
}

template <typename Real>
Real gammaDecoded(Real y) {
  return y > 0.04045f ? power((y + 0.055f) / 1.055f, 2.4f) : y / 12.92f;
}

template <typename Real>
Real whitePoint(Real c, Real white) {
  return (c * (1.0f + c / (white * white))) / (1.0f + c);
}

template <typename Real>
Real inverseWhitePoint(Real y, Real white) {
  const Real squared = white * white, rest = 1.0f - y;
  const Real root = sqrt(rest * rest + (4.0f * y) / squared);
  return y <= 1.0f ? (2.0f * y) / (rest + root) : ((root - rest) * squared) / 2.0f;
}

#define TAA_TONE_CURVES(Real)                                                                                \
  template Real pq(Real c);                                                                                  \
  template Real inversePq(Real y);                                                                           \
  template Real logarithm(Real c);                                                                           \
  template Real inverseLogarithm(Real y);                                                                    \
  template Real gammaEncoded(Real c);                                                                        \
  template Real gammaDecoded(Real y);                                                                        \
  template Real whitePoint(Real c, Real white);                                                              \
  template Real inverseWhitePoint(Real y, Real white);
TAA_EACH_NUMBER(TAA_TONE_CURVES)
#undef TAA_TONE_CURVES

} // namespace taa::twin
