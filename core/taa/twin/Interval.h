// Numbers that know what a driver may make of them: ranges, through the stages themselves.
//
// What GLSL allows (GLSL 4.60, 4.7.1; the resolve marks its arithmetic `precise`, so nothing is fused or
// reordered): + − × rounded correctly, to the nearest as every GPU does; ÷ within 2.5 ulp, square roots as 1
// over an inverse root, 2 ulp more; numbers below the normal ones may be 0. Texels, the settings and what is
// computed on the CPU are what they are.
#pragma once

#include "core/taa/twin/Numbers.h"
#include "core/taa/twin/Twin.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace taa::twin {

/// The twin's value, and the least and greatest that a driver may have in its place. All of them NaN: it is
/// NaN. From −∞ to ∞: anything, NaN too.
struct Interval {
  float value;
  float low, high;
  /// The same in copies, so that what a driver has in one is what it has in the other; 0: one float.
  std::uint32_t origin;

  Interval() = default;
  template <typename Number>
  requires std::is_arithmetic_v<Number>
  // NOLINTNEXTLINE(google-explicit-constructor): a literal is a number
  constexpr Interval(Number value_)
      : value(static_cast<float>(value_)), low(static_cast<float>(value_)), high(static_cast<float>(value_)),
        origin(0) {}
  Interval(float value_, float low_, float high_)
      : value(value_), low(low_), high(high_), origin(low_ == high_ ? 0 : newOrigin()) {}
  explicit operator double() const { return static_cast<double>(value); } ///< to what the CPU computes
  explicit operator int() const { return static_cast<int>(value); }       ///< of floor()

  static constexpr float kInfinity = std::numeric_limits<float>::infinity();
  static Interval anything(float value) { return {value, -kInfinity, kInfinity}; }
  bool isAnything() const { return low == -kInfinity && high == kInfinity; }
  bool isPoint() const { return low == high && low == value; }
  bool isNan() const { return std::isnan(low); }
  /// Whether both are the same finite number, whatever a driver makes of it.
  bool isSame(const Interval& other) const {
    return origin != 0 && origin == other.origin && high - low < kInfinity;
  }
  bool contains(float x) const { return isAnything() || (isNan() ? std::isnan(x) : x >= low && x <= high); }

  friend Interval operator+(const Interval& a, const Interval& b) {
    return made(a.value + b.value, a.low + b.low, a.high + b.high);
  }
  friend Interval operator-(const Interval& a, const Interval& b) {
    if (a.isSame(b)) return 0.0f;
    return made(a.value - b.value, a.low - b.high, a.high - b.low);
  }
  friend Interval operator*(const Interval& a, const Interval& b);
  friend Interval operator/(const Interval& a, const Interval& b);
  friend Interval operator-(const Interval& a) { return {-a.value, -a.high, -a.low}; }
  Interval& operator+=(const Interval& b) { return *this = *this + b; }
  Interval& operator-=(const Interval& b) { return *this = *this - b; }
  Interval& operator*=(const Interval& b) { return *this = *this * b; }
  Interval& operator/=(const Interval& b) { return *this = *this / b; }

  // Where both may be, the present Observation chooses.
  friend bool operator<(const Interval& a, const Interval& b);
  friend bool operator<=(const Interval& a, const Interval& b);
  friend bool operator>(const Interval& a, const Interval& b) { return b < a; }
  friend bool operator>=(const Interval& a, const Interval& b) { return b <= a; }
  friend bool operator==(const Interval& a, const Interval& b);

  friend Interval sqrt(const Interval& x);
  friend Interval fabs(const Interval& x);
  friend Interval floor(const Interval& x);
  friend bool isnan(const Interval& x);

  /// With numbers that may become 0, and anything where an operation has no result.
  static Interval made(float value, float low, float high) {
    constexpr float kNormal = std::numeric_limits<float>::min();
    if (std::isnan(low) || std::isnan(high)) [[unlikely]]
      return std::isnan(low) && std::isnan(high) && std::isnan(value) ? Interval{value, value, value}
                                                                      : anything(value);
    if (low > 0.0f && low < kNormal) low = 0.0f;
    if (high < 0.0f && high > -kNormal) high = 0.0f;
    return {value, low, high};
  }

 private:
  static std::uint32_t newOrigin();
};

template <>
struct WideOf<Interval> {
  using Type = double; // weights of a frame, which the CPU computes
};

template <>
struct Source<Interval> {
  static Vec4<Interval> read(const Texels& plane, int x, int y) {
    const glm::vec4 texel = plane.texel(x, y);
    Vec4<Interval> out;
    for (int i = 0; i < 4; ++i) out[i] = Interval::made(texel[i], texel[i], texel[i]);
    return out;
  }
  static Interval number(const float& field) { return field; }
};

/// What a driver made of a pixel. As long as it lives, Intervals of this thread go through the stages with
/// the driver's values of the rows: each is compared with its range, and taken in its place. Where a
/// comparison or floor() could go both ways the next bit of `script` decides, and behind its end what the
/// twin's values say.
class Observation {
 public:
  Observation(const PixelRecord& found, const std::bitset<kIntermediateCount>& rows,
              std::vector<bool> script);
  ~Observation();
  Observation(const Observation&) = delete;
  Observation& operator=(const Observation&) = delete;

  struct Decision {
    bool is = false;
    std::size_t before = 0; ///< values compared before it
  };
  struct Compared {
    IntermediateId id{};
    int channel = 0;
    float found = 0.0f;
    Interval allowed{};
    bool isInside() const { return allowed.contains(found); }
  };
  const std::vector<Decision>& decisions() const { return decisions_; }
  const std::vector<Compared>& compared() const { return compared_; }

 private:
  friend bool chosen(bool likely);
  friend void observe(IntermediateId id, Interval& value, int channel);

  const PixelRecord& found_;
  const std::bitset<kIntermediateCount>& rows_;
  std::vector<bool> script_;
  std::vector<Decision> decisions_;
  std::vector<Compared> compared_;
  std::bitset<4 * kIntermediateCount> done_;
  Observation* before_;
};

void observe(IntermediateId id, Interval& value, int channel = 0);

/// `rounding` is exact, and of what is larger no less.
template <typename Rounding>
Interval roundedBy(const Interval& x, Rounding rounding) {
  return Interval::made(rounding(x.value), rounding(x.low), rounding(x.high));
}
/// Of the resolve's storing (Blend.cpp), whose quotient may err.
Interval quantized(const Interval& x, float steps, float u);
Interval minimum(const Interval& a, const Interval& b);
Interval maximum(const Interval& a, const Interval& b);
Interval bounded(const Interval& value, const Interval& low, const Interval& high);
Interval saturated(const Interval& x);
/// Distance of the floats around x, at least that of the smallest normal ones.
double unitInLastPlace(double x);
/// Which way a comparison goes that could go both: the `likely` one, unless the present Observation has a
/// script.
bool chosen(bool likely);

} // namespace taa::twin
