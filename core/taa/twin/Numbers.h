// What the stages compute with. They are templates on their number: float is what a GPU would compute; what
// remembers more than a value, as a Dual does how it changes, runs through the same functions.
#pragma once

#include "core/taa/twin/Powers.h"
#include "core/taa/twin/Texels.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cmath>
#include <concepts>
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
