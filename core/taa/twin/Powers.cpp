// Both are series about the nearest power of two; order of operations as in the definition of the resolve.
#include "core/taa/twin/Powers.h"

#include "core/taa/twin/Interval.h"
#include "core/taa/twin/Numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace taa::twin {
namespace {

/// 2/((2k + 1) ln 2): log₂((1 + t)/(1 − t)) is their sum with t²ᵏ⁺¹. Left out is less than 2·10⁻⁹ of it.
constexpr std::array<float, 5> kLogarithm = [] {
  std::array<float, 5> terms{};
  for (std::size_t k = 0; k < terms.size(); ++k)
    terms[k] = static_cast<float>(2.0 / (std::numbers::ln2 * static_cast<double>(2 * k + 1)));
  return terms;
}();

/// (ln 2)ᵏ⁺¹/(k + 1)!: 2ˣ − 1 is their sum with xᵏ⁺¹. Left out is less than 6·10⁻⁹ up to |x| = ½.
constexpr std::array<float, 7> kPower = [] {
  std::array<float, 7> terms{};
  double term = 1.0;
  for (std::size_t k = 0; k < terms.size(); ++k) {
    term *= std::numbers::ln2 / static_cast<double>(k + 1);
    terms[k] = static_cast<float>(term);
  }
  return terms;
}();

/// Σ terms[k]·xᵏ, from the last.
template <typename Real, std::size_t kCount>
Real series(const std::array<float, kCount>& terms, Real x) {
  Real sum = terms.back();
  for (std::size_t k = kCount - 1; k-- > 0;) sum = sum * x + terms[k];
  return sum;
}

// x = m·2^exponent, m from √½ to √2
int exponentOf(float x) {
  int exponent = 0;
  const float m = std::frexp(x, &exponent); // ½ to 1
  return m < std::numbers::sqrt2_v<float> / 2.0f ? exponent - 1 : exponent;
}
int exponentOf(const Interval& x) {
  const auto of = [](float end) { return exponentOf(std::max(end, std::numeric_limits<float>::min())); };
  const int likely = of(x.value), low = of(x.low), high = of(x.high);
  if (low == high || chosen(true)) return likely;
  return likely == low ? high : low;
}

float timesPowerOfTwo(float x, int exponent) {
  return std::ldexp(x, exponent);
}
Interval timesPowerOfTwo(const Interval& x, int exponent) {
  return {std::ldexp(x.value, exponent), std::ldexp(x.low, exponent), std::ldexp(x.high, exponent)};
}

/// 2^x = whole·(1 + rest).
template <typename Real>
struct PowerOfTwo {
  float whole;
  Real rest;
};
template <typename Real>
PowerOfTwo<Real> powerOfTwo(Real x) {
  const Real within = minimum(maximum(x, -126.0f), 127.0f); // NaN: −126
  const Real nearest = floor(within + 0.5f);
  const Real f = within - nearest;
  return {std::ldexp(1.0f, static_cast<int>(nearest)), f * series(kPower, f)};
}

} // namespace

template <typename Real>
Real log2OfRatio(Real t) {
  return t * series(kLogarithm, t * t);
}

template <typename Real>
Real log2Of(Real x) {
  const int exponent = exponentOf(x);
  const Real m = timesPowerOfTwo(x, -exponent);
  return static_cast<float>(exponent) + log2OfRatio<Real>((m - 1.0f) / (m + 1.0f));
}

template <typename Real>
Real log2OfOnePlus(Real x) {
  if (x < std::numbers::sqrt2_v<float> - 1.0f) return log2OfRatio<Real>(x / (2.0f + x));
  return log2Of<Real>(1.0f + x);
}

template <typename Real>
Real exp2Of(Real x) {
  if (!(x >= -126.0f)) return 0.0f;
  const PowerOfTwo<Real> parts = powerOfTwo(x);
  return parts.whole * (1.0f + parts.rest);
}

template <typename Real>
Real exp2LessOne(Real x) {
  const PowerOfTwo<Real> parts = powerOfTwo(x);
  return parts.whole * parts.rest + (parts.whole - 1.0f);
}

template <typename Real>
Real power(Real x, std::type_identity_t<Real> e) {
  return x >= 1e-37f ? exp2Of<Real>(e * log2Of(x)) : Real(0.0f);
}

#define TAA_POWERS(Real)                                                                                     \
  template Real log2OfRatio(Real t);                                                                         \
  template Real log2Of(Real x);                                                                              \
  template Real log2OfOnePlus(Real x);                                                                       \
  template Real exp2Of(Real x);                                                                              \
  template Real exp2LessOne(Real x);                                                                         \
  template Real power(Real x, std::type_identity_t<Real> e);
TAA_POWERS(float)
TAA_POWERS(Interval)
#undef TAA_POWERS

} // namespace taa::twin
