// Both are series about the nearest power of two; order of operations as in the definition of the resolve.
#include "core/taa/twin/Powers.h"

#include <array>
#include <cmath>
#include <cstddef>
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
template <std::size_t kCount>
float series(const std::array<float, kCount>& terms, float x) {
  float sum = terms.back();
  for (std::size_t k = kCount - 1; k-- > 0;) sum = sum * x + terms[k];
  return sum;
}

/// 2^x = whole·(1 + rest).
struct PowerOfTwo {
  float whole, rest;
};
PowerOfTwo powerOfTwo(float x) {
  const float within = x > -126.0f ? (x < 127.0f ? x : 127.0f) : -126.0f; // NaN: −126
  const float nearest = std::floor(within + 0.5f);
  const float f = within - nearest;
  return {std::ldexp(1.0f, static_cast<int>(nearest)), f * series(kPower, f)};
}

} // namespace

float log2OfRatio(float t) {
  return t * series(kLogarithm, t * t);
}

float log2Of(float x) {
  int exponent = 0;
  float m = std::frexp(x, &exponent); // ½ to 1
  if (m < std::numbers::sqrt2_v<float> / 2.0f) {
    m = 2.0f * m;
    --exponent;
  }
  return static_cast<float>(exponent) + log2OfRatio((m - 1.0f) / (m + 1.0f));
}

float log2OfOnePlus(float x) {
  if (x < std::numbers::sqrt2_v<float> - 1.0f) return log2OfRatio(x / (2.0f + x));
  return log2Of(1.0f + x);
}

float exp2Of(float x) {
  if (!(x >= -126.0f)) return 0.0f;
  const PowerOfTwo parts = powerOfTwo(x);
  return parts.whole * (1.0f + parts.rest);
}

float exp2LessOne(float x) {
  const PowerOfTwo parts = powerOfTwo(x);
  return parts.whole * parts.rest + (parts.whole - 1.0f);
}

float power(float x, float e) {
  return x >= 1e-37f ? exp2Of(e * log2Of(x)) : 0.0f;
}

} // namespace taa::twin
