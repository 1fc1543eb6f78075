// Numbers that know how fast they change with one thing: forward differentiation, through the stages
// themselves.
#pragma once

#include "core/taa/twin/Numbers.h"

#include <glm/vec2.hpp>

#include <cmath>
#include <compare>
#include <type_traits>
#include <vector>

namespace taa::twin {

/// Says to the present Seeding that two such were met; `isOpen`: in a comparison.
void noteTie(bool isOpen);

/// A value, as the stages have it bit for bit, and its derivative by the seed, to the side that the seed
/// goes: where minimum(), maximum() or fabs() have a corner, theirs is the slope to that side. Comparisons
/// are of values alone. Rounding (to half floats, to steps) passes slopes on; a root of 0 has none.
template <typename Value>
struct DualOf {
  Value value;
  double slope;

  DualOf() = default;
  template <typename Number>
  requires std::is_arithmetic_v<Number>
  // NOLINTNEXTLINE(google-explicit-constructor): a literal is a number that does not change
  constexpr DualOf(Number value_) : value(static_cast<Value>(value_)), slope(0.0) {}
  constexpr DualOf(Value value_, double slope_) : value(value_), slope(slope_) {}
  template <typename Other>
  explicit DualOf(const DualOf<Other>& other) : value(static_cast<Value>(other.value)), slope(other.slope) {}
  explicit operator int() const { return static_cast<int>(value); }

  friend DualOf operator+(DualOf a, DualOf b) { return {a.value + b.value, a.slope + b.slope}; }
  friend DualOf operator-(DualOf a, DualOf b) { return {a.value - b.value, a.slope - b.slope}; }
  friend DualOf operator*(DualOf a, DualOf b) {
    return {a.value * b.value, a.slope * b.wide() + b.slope * a.wide()};
  }
  friend DualOf operator/(DualOf a, DualOf b) {
    return {a.value / b.value, (a.slope - a.wide() / b.wide() * b.slope) / b.wide()};
  }
  friend DualOf operator-(DualOf a) { return {-a.value, -a.slope}; }
  DualOf& operator+=(DualOf b) { return *this = *this + b; }
  DualOf& operator-=(DualOf b) { return *this = *this - b; }
  DualOf& operator*=(DualOf b) { return *this = *this * b; }
  DualOf& operator/=(DualOf b) { return *this = *this / b; }

  friend bool operator==(DualOf a, DualOf b) { return a.value == b.value; }
  friend auto operator<=>(DualOf a, DualOf b) {
    if (a.partsFrom(b)) noteTie(true);
    return a.value <=> b.value;
  }

  friend DualOf sqrt(DualOf x) {
    const Value root = std::sqrt(x.value);
    return {root, x.slope == 0.0 ? 0.0 : x.slope / (2.0 * static_cast<double>(root))};
  }
  friend DualOf fabs(DualOf x) {
    if (x.partsFrom(0)) noteTie(false);
    if (x.value == Value(0)) return {std::fabs(x.value), std::fabs(x.slope)};
    return {std::fabs(x.value), std::signbit(x.value) ? -x.slope : x.slope};
  }
  friend DualOf floor(DualOf x) { return {std::floor(x.value), 0.0}; }
  friend bool isnan(DualOf x) { return std::isnan(x.value); }
  friend DualOf exp(DualOf x) {
    const Value power = std::exp(x.value);
    return {power, x.slope * static_cast<double>(power)};
  }
  friend DualOf cos(DualOf x) { return {std::cos(x.value), -std::sin(x.wide()) * x.slope}; }

  double wide() const { return static_cast<double>(value); }
  /// Whether the two are the same, but do not change the same way.
  bool partsFrom(DualOf other) const { return value == other.value && slope != other.slope; }
};

using Dual = DualOf<float>;

template <>
struct WideOf<Dual> {
  using Type = DualOf<double>;
};

/// What derivatives are by: a texel of a plane, all of its channels alike, or a number of the settings.
struct Seed {
  const Texels* plane = nullptr;
  glm::ivec2 texel{0};
  const float* setting = nullptr; ///< a field of the settings that the resolve is given
  double direction = 1.0;         ///< −1: it falls
};

/// What was read, each once, in the order of the first time.
struct Reads {
  struct Texel {
    const Texels* plane;
    glm::ivec2 texel;
    bool operator==(const Texel&) const = default;
  };
  std::vector<Texel> texels;
  std::vector<const float*> numbers;
};

/// As long as it lives, Duals of this thread are by that seed (of an empty one by nothing).
class Seeding {
 public:
  explicit Seeding(const Seed& seed);
  ~Seeding();
  Seeding(const Seeding&) = delete;
  Seeding& operator=(const Seeding&) = delete;

  /// Whether two numbers were met that are the same but do not change the same way: there the slope to the
  /// other side may be another.
  bool hasTie() const { return hasTie_; }
  /// Whether a comparison was among them, so that neither slope may be right.
  bool hasOpenTie() const { return hasOpenTie_; }
  /// Of an empty seed; else none.
  const Reads& reads() const { return reads_; }

 private:
  bool collects() const { return !seed_.plane && !seed_.setting; }
  friend struct Source<Dual>;
  friend void noteTie(bool isOpen);

  Seed seed_;
  Seeding* before_;
  bool hasTie_ = false, hasOpenTie_ = false;
  Reads reads_;
};

template <>
struct Source<Dual> {
  static Vec4<Dual> read(const Texels& plane, int x, int y);
  static Dual number(const float& field);
};

template <typename Rounding>
Dual roundedBy(Dual x, Rounding rounding) {
  return {rounding(x.value), x.slope};
}
Dual minimum(Dual a, Dual b);
Dual maximum(Dual a, Dual b);
Dual bounded(Dual value, Dual low, Dual high);
Dual saturated(Dual x);
Dual log2Of(Dual x);
Dual log2OfRatio(Dual t);
Dual log2OfOnePlus(Dual x);
Dual exp2Of(Dual x);
Dual exp2LessOne(Dual x);
Dual power(Dual x, Dual e);

} // namespace taa::twin
