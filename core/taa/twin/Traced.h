// Numbers that remember how they were made: each operation is a node of a graph, from which the formula of
// any value is written with the numbers put in.
#pragma once

#include "core/settings/Parameters.h"
#include "core/taa/Intermediates.h"
#include "core/taa/twin/Numbers.h"
#include "core/taa/twin/Twin.h"

#include <array>
#include <cmath>
#include <compare>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace taa::twin {

enum class Operation : std::uint8_t {
  Plus,
  Minus,
  Times,
  Over,
  Negative,
  Root,
  Absolute,
  Floor,
  Min,
  Max,
  Clamp, ///< of three: value, low, high
  Smooth,
  Exp,
  Cos,
  Exp2,
  Exp2LessOne,
  Log2,
  Log2OfOnePlus,
  Log2OfRatio,
  Power,
  Rounded, ///< as it is stored
  Read,    ///< a number of the inputs
  Setting, ///< a number of the settings
  Named    ///< a value that formulas state as a number
};

/// A number and what it came from; 0: a literal.
struct Operand {
  double value = 0.0;
  std::uint32_t node = 0;
  bool operator==(const Operand&) const = default;
};
struct TraceNode {
  Operation operation{};
  std::array<Operand, 3> from{};
  double value = 0.0;
};

/// Two numbers that were compared, of which one at least is no literal.
struct Compared {
  Operand a, b;
  bool operator==(const Compared&) const = default;
};

/// As long as it lives, operations of this thread's traced numbers are written down in it.
class Tracing {
 public:
  Tracing();
  ~Tracing();
  Tracing(const Tracing&) = delete;
  Tracing& operator=(const Tracing&) = delete;
  std::vector<TraceNode> take() { return std::move(nodes_); }
  /// Nodes that are numbers of the settings, and where these lie.
  using SettingReads = std::vector<std::pair<std::uint32_t, const float*>>;
  const SettingReads& settings() const { return settings_; }
  using Decisions = std::array<std::vector<Compared>, kIntermediateCount>;
  const Decisions& decisions() const { return decisions_; }

  /// The number of the node; 0 where nothing is traced.
  static std::uint32_t add(Operation operation, const std::array<Operand, 3>& from, double value);
  static void compare(const Operand& a, const Operand& b);
  static void decide(IntermediateId id, bool isAll);
  static void forget();
  static void read(std::uint32_t node, const float* field);

 private:
  Tracing* before_;
  std::vector<TraceNode> nodes_;
  SettingReads settings_;
  std::vector<Compared> compared_; ///< that have decided no row yet
  Decisions decisions_;
};

template <typename Value>
struct TracedOf {
  Value value;
  std::uint32_t node;

  TracedOf() = default;
  template <typename Number>
  requires std::is_arithmetic_v<Number>
  // NOLINTNEXTLINE(google-explicit-constructor): a literal is a number
  constexpr TracedOf(Number value_) : value(static_cast<Value>(value_)), node(0) {}
  constexpr TracedOf(Value value_, std::uint32_t node_) : value(value_), node(node_) {}
  template <typename Other>
  explicit TracedOf(const TracedOf<Other>& other)
      : value(static_cast<Value>(other.value)), node(other.node) {}
  explicit operator int() const { return static_cast<int>(value); }
  Operand operand() const { return {static_cast<double>(value), node}; }

  static TracedOf made(Operation operation, Value value, TracedOf a, TracedOf b = 0, TracedOf c = 0) {
    return {value,
            Tracing::add(operation, {a.operand(), b.operand(), c.operand()}, static_cast<double>(value))};
  }

  friend TracedOf operator+(TracedOf a, TracedOf b) { return made(Operation::Plus, a.value + b.value, a, b); }
  friend TracedOf operator-(TracedOf a, TracedOf b) {
    return made(Operation::Minus, a.value - b.value, a, b);
  }
  friend TracedOf operator*(TracedOf a, TracedOf b) {
    return made(Operation::Times, a.value * b.value, a, b);
  }
  friend TracedOf operator/(TracedOf a, TracedOf b) { return made(Operation::Over, a.value / b.value, a, b); }
  friend TracedOf operator-(TracedOf a) { return made(Operation::Negative, -a.value, a); }
  TracedOf& operator+=(TracedOf b) { return *this = *this + b; }
  TracedOf& operator-=(TracedOf b) { return *this = *this - b; }
  TracedOf& operator*=(TracedOf b) { return *this = *this * b; }
  TracedOf& operator/=(TracedOf b) { return *this = *this / b; }

  friend bool operator==(TracedOf a, TracedOf b) {
    Tracing::compare(a.operand(), b.operand());
    return a.value == b.value;
  }
  friend auto operator<=>(TracedOf a, TracedOf b) {
    Tracing::compare(a.operand(), b.operand());
    return a.value <=> b.value;
  }

  friend TracedOf sqrt(TracedOf x) { return made(Operation::Root, std::sqrt(x.value), x); }
  friend TracedOf fabs(TracedOf x) { return made(Operation::Absolute, std::fabs(x.value), x); }
  friend TracedOf floor(TracedOf x) { return made(Operation::Floor, std::floor(x.value), x); }
  friend TracedOf exp(TracedOf x) { return made(Operation::Exp, std::exp(x.value), x); }
  friend TracedOf cos(TracedOf x) { return made(Operation::Cos, std::cos(x.value), x); }
  friend bool isnan(TracedOf x) { return std::isnan(x.value); }
};

using Traced = TracedOf<float>;

template <>
struct WideOf<Traced> {
  using Type = TracedOf<double>;
};

template <>
struct Source<Traced> {
  static Vec4<Traced> read(const Texels& plane, int x, int y) {
    Vec4<Traced> out(plane.texel(x, y));
    for (int i = 0; i < 4; ++i) out[i] = Traced::made(Operation::Read, out[i].value, out[i]);
    return out;
  }
  static Traced number(const float& field) {
    const Traced out = Traced::made(Operation::Setting, field, field);
    Tracing::read(out.node, &field);
    return out;
  }
};

template <>
inline void decided<Traced>(IntermediateId id, bool isAll) {
  Tracing::decide(id, isAll);
}
template <>
inline void searched<Traced>() {
  Tracing::forget();
}

template <typename Rounding>
Traced roundedBy(Traced x, Rounding rounding) {
  return Traced::made(Operation::Rounded, rounding(x.value), x);
}
Traced minimum(Traced a, Traced b);
Traced maximum(Traced a, Traced b);
Traced bounded(Traced value, Traced low, Traced high);
Traced saturated(Traced x);
Traced smooth(Traced x);
Traced named(Traced x);
Traced powerOf256ths(Traced x, int steps);
Traced log2Of(Traced x);
Traced log2OfRatio(Traced t);
Traced log2OfOnePlus(Traced x);
Traced exp2Of(Traced x);
Traced exp2LessOne(Traced x);
Traced power(Traced x, Traced e);

/// How everything that is known of a pixel was made.
struct Trace {
  std::vector<TraceNode> nodes; ///< node n at n − 1, after what it is made of
  std::array<std::array<Operand, 4>, kIntermediateCount> rows{};
  std::array<Operand, 3> rectifiedBox{}; ///< of PixelIn
  /// By row: what was compared on the way to it, in this order, each once.
  Tracing::Decisions decisions;
  std::vector<std::pair<std::uint32_t, const Parameter*>> settings; ///< nodes that are numbers of them

  const TraceNode& at(const Operand& operand) const { return nodes[operand.node - 1]; }
  const std::array<Operand, 4>& of(IntermediateId id) const { return rows[static_cast<std::size_t>(id)]; }
};
Trace traceOf(const Inputs& inputs, const Settings& settings, const glm::ivec2& pixel);

} // namespace taa::twin
