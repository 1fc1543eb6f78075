// What the stages compute with. They are templates on their number: float is what a GPU would compute; what
// remembers more than a value, as a Dual does how it changes, runs through the same functions.
#pragma once

#include "core/taa/twin/Powers.h"
#include "core/taa/twin/Texels.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cmath>
#include <type_traits>

namespace taa::twin {

template <typename Real>
using Vec2 = glm::vec<2, Real>;
template <typename Real>
using Vec3 = glm::vec<3, Real>;
template <typename Real>
using Vec4 = glm::vec<4, Real>;

/// A parameter that takes its number type from others, so that it may be a literal.
template <typename Real>
using Same = std::type_identity_t<Real>;

/// The number that weights of a frame are computed in before they are rounded: of float double.
template <typename Real>
struct WideOf;
template <>
struct WideOf<float> {
  using Type = double;
};
template <typename Real>
using Wide = typename WideOf<Real>::Type;

// What else than + − × ÷ and comparisons numbers have; others than floats bring their own.
using std::cos;
using std::exp;
using std::fabs;
using std::floor;
using std::isnan;
using std::sqrt;

/// `x` as `rounding`, of floats, leaves it.
template <typename Rounding>
float roundedBy(float x, Rounding rounding) {
  return rounding(x);
}

/// Where numbers come from: a texel of a plane, and a number of the settings (the field itself, no copy).
template <typename Real>
struct Source;
template <>
struct Source<float> {
  static glm::vec4 read(const Texels& plane, int x, int y) { return plane.texel(x, y); }
  static float number(const float& field) { return field; }
};
template <typename Real>
Vec4<Real> read(const Texels& plane, const glm::ivec2& texel) {
  return Source<Real>::read(plane, texel.x, texel.y);
}
template <typename Real>
Real number(const float& field) {
  return Source<Real>::number(field);
}

/// The integer below.
template <typename Real>
int whole(Real x) {
  return static_cast<int>(floor(x));
}

// By comparisons, so that what NaN does is defined.
template <typename Real = float>
Real minimum(Real a, Same<Real> b) {
  return a < b ? a : b;
}
template <typename Real = float>
Real maximum(Real a, Same<Real> b) {
  return a > b ? a : b;
}
template <typename Real = float>
Real bounded(Real value, Same<Real> low, Same<Real> high) {
  const Real atLeast = value < low ? low : value; // the upper wall has the last word
  return atLeast > high ? high : atLeast;
}
/// Within 0 and 1; NaN becomes 0.
template <typename Real = float>
Real saturated(Real x) {
  return x > 0.0f ? (x < 1.0f ? x : Real(1.0f)) : Real(0.0f);
}
/// x²(3 − 2x) of that.
template <typename Real = float>
Real smooth(Real x) {
  const Real t = saturated(x);
  return (t * t) * (3.0f - 2.0f * t);
}
/// x^(steps/256) by whole powers and square roots; steps ≥ 0.
template <typename Real = float>
Real powerOf256ths(Real x, int steps) {
  Real result = 1.0f;
  for (int left = steps / 256; left > 0; --left) result = result * x;
  Real root = x;
  for (int bit = 7; bit >= 0; --bit) {
    root = sqrt(root);
    if ((steps >> bit & 1) != 0) result = result * root;
  }
  return result;
}

/// The same value, which formulas state as a number, however it was made.
template <typename Real = float>
Real named(Real x) {
  return x;
}
template <typename Real = float>
Vec3<Real> named(const Vec3<Real>& color) {
  return {named(color.x), named(color.y), named(color.z)};
}

/// A number of ours, no float.
template <typename Real>
concept Remembering = std::is_class_v<Real> && requires {
  typename WideOf<Real>::Type;
};

// Colors and places with literals. (glm's own take both of one type.)
template <glm::length_t n, Remembering Real>
glm::vec<n, Real> operator+(float a, const glm::vec<n, Real>& b) {
  return Real(a) + b;
}
template <glm::length_t n, Remembering Real>
glm::vec<n, Real> operator+(const glm::vec<n, Real>& a, float b) {
  return a + Real(b);
}
template <glm::length_t n, Remembering Real>
glm::vec<n, Real> operator-(float a, const glm::vec<n, Real>& b) {
  return Real(a) - b;
}
template <glm::length_t n, Remembering Real>
glm::vec<n, Real> operator-(const glm::vec<n, Real>& a, float b) {
  return a - Real(b);
}
template <glm::length_t n, Remembering Real>
glm::vec<n, Real> operator*(float a, const glm::vec<n, Real>& b) {
  return Real(a) * b;
}
template <glm::length_t n, Remembering Real>
glm::vec<n, Real> operator/(const glm::vec<n, Real>& a, float b) {
  return a / Real(b);
}

} // namespace taa::twin
