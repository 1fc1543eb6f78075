#include "core/explanation/FormulaText.h"

#include "core/base/NumberText.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <utility>
#include <vector>

namespace taa::explanation {

namespace {

using twin::Operand;
using twin::Operation;
using twin::TraceNode;

/// What binds how strongly.
enum Strength { kSum, kProduct, kPower, kAtom };

/// A number, or one for each channel.
using Many = std::vector<Operand>;

bool areLiteral(const Many& all) {
  return std::ranges::all_of(all, [](const Operand& x) { return x.node == 0; });
}

bool areExactly(const Many& all, double value) {
  return std::ranges::all_of(all, [value](const Operand& x) { return x.value == value; });
}

bool areSame(const Many& a, const Many& b) {
  return std::ranges::equal(
      a, b, [](const Operand& x, const Operand& y) { return x.node == y.node && x.value == y.value; });
}

/// Channels that are made alike.
struct Made {
  Operation operation{};
  std::array<Many, 3> from;
  Many result;
};

class Writer {
 public:
  /// `stage`: of the row.
  Writer(const twin::Trace& trace, const FormulaStyle& style, std::optional<Stage> stage)
      : trace_(trace), style_(style) {
    for (const Intermediate& row : kIntermediates)
      for (const Operand& of : trace.of(row.id)) {
        if (of.node == 0) continue;
        rows_.insert(of.node);
        const bool isOpen = style.depth == FormulaDepth::Samples ||
                            (style.depth == FormulaDepth::Stage && row.stage == stage);
        if (!isOpen) stated_.insert(of.node);
      }
    isConstant_.push_back(true); // literals
    for (const TraceNode& node : trace.nodes) {
      const bool isLeaf = node.operation == Operation::Read || node.operation == Operation::Setting;
      isConstant_.push_back(!isLeaf && std::ranges::all_of(node.from, [this](const Operand& x) {
        return isConstant_[x.node];
      }));
    }
  }

  /// Nothing: the channels are made in different ways.
  std::optional<std::string> text(Many at) {
    for (const Operand& x : at) stated_.erase(x.node), rows_.erase(x.node);
    bool isOpened = false;     // a named value was, which numbers state as well
    while (!areConstant(at)) { // down to what was computed
      if (const Many inside = relevant(at); !areSame(inside, at)) {
        at = inside;
        continue;
      }
      if (areRows(at)) {
        if (!style_.unfolds) break;
        for (const Operand& x : at) stated_.erase(x.node), rows_.erase(x.node);
        continue;
      }
      const auto made = madeOf(at);
      if (made && made->operation == Operation::Named) {
        isOpened = true;
        at = made->from[0];
        continue;
      }
      if (made && (made->operation == Operation::Setting || made->operation == Operation::Read)) break;
      const std::string out = made ? written(*made, kSum) : "";
      if (made && !isUneven_) return out;
      if (isOpened) break;
      return {};
    }
    return tuple(at);
  }

 private:
  std::string number(const Operand& x) const { return numberText(x.value, style_.digits); }

  std::string tuple(const Many& all) const {
    if (all.size() == 1) return number(all.front());
    std::string text;
    for (const Operand& x : all) text += (text.empty() ? "(" : ", ") + number(x);
    return text + ")";
  }

  /// One for all where it is the same one.
  std::string numbers(const Many& all) const {
    const bool isOne = std::ranges::all_of(
        all, [&](const Operand& x) { return x.node == all.front().node && x.value == all.front().value; });
    return isOne ? number(all.front()) : tuple(all);
  }

  bool isStated(const Operand& x) const {
    if (isConstant_[x.node] || stated_.contains(x.node)) return true;
    const Operation operation = trace_.at(x).operation;
    const bool isWhole = left_ > 0; // as deep as was asked for
    if (!isWhole && rows_.contains(x.node)) return true;
    return (operation == Operation::Named && !(isWhole && style_.depth == FormulaDepth::Samples)) ||
           operation == Operation::Setting || operation == Operation::Read;
  }
  bool areStated(const Many& all) const {
    return std::ranges::all_of(all, [this](const Operand& x) { return isStated(x); });
  }

  bool areConstant(const Many& all) const {
    return std::ranges::all_of(all, [this](const Operand& x) { return isConstant_[x.node]; });
  }

  bool areRows(const Many& all) const {
    return std::ranges::all_of(all, [this](const Operand& x) { return stated_.contains(x.node); });
  }

  /// Nothing where one of them is a literal, or they are made in different ways.
  std::optional<Made> madeOf(const Many& all) const {
    Made out;
    out.result = all;
    for (const Operand& x : all) {
      if (x.node == 0) return {};
      const TraceNode& node = trace_.at(x);
      if (&x != all.data() && node.operation != out.operation) return {};
      out.operation = node.operation;
      for (std::size_t i = 0; i < out.from.size(); ++i) out.from[i].push_back(node.from[i]);
    }
    return out;
  }

  /// Past operations that change nothing, but not past what is stated.
  Many relevant(const Many& all) const {
    if (areStated(all)) return all;
    const auto made = madeOf(all);
    if (!made) return all;
    if (const Many* same = sameAs(*made)) return relevant(*same);
    if (made->operation == Operation::Minus && areExactly(made->from[0], 1.0)) { // 1 − (1 − y)
      const Many rest = relevant(made->from[1]);
      const auto inner = areStated(rest) ? std::nullopt : madeOf(rest);
      if (inner && inner->operation == Operation::Minus && areExactly(inner->from[0], 1.0))
        return relevant(inner->from[1]);
    }
    return all;
  }

  /// The operand that the operation leaves as it is; null: it changes each.
  const Many* sameAs(const Made& made) const {
    const Many &a = made.from[0], &b = made.from[1];
    switch (made.operation) {
    case Operation::Times:
      if (isLiteral(a, 0.0)) return &a;
      if (isLiteral(b, 0.0)) return &b;
      return areExactly(a, 1.0) ? &b : areExactly(b, 1.0) ? &a : nullptr;
    case Operation::Over:
      return areExactly(b, 1.0) ? &a : nullptr;
    case Operation::Plus:
      return areExactly(a, 0.0) ? &b : areExactly(b, 0.0) ? &a : nullptr;
    case Operation::Minus:
      return areExactly(b, 0.0) ? &a : nullptr;
    case Operation::Min:
    case Operation::Max:
      if (areLiteral(b) && !areLiteral(a) && isValueOf(a, made.result)) return &a;
      return areLiteral(a) && !areLiteral(b) && isValueOf(b, made.result) ? &b : nullptr;
    case Operation::Clamp:
      return isValueOf(a, made.result) ? &a : nullptr;
    case Operation::Rounded: // what storing does to it is said beside it
      return &a;
    default:
      return nullptr;
    }
  }

  static bool isLiteral(const Many& all, double value) { return areLiteral(all) && areExactly(all, value); }

  static bool isValueOf(const Many& a, const Many& b) {
    return std::ranges::equal(a, b, {}, &Operand::value, &Operand::value);
  }

  std::string of(const Many& given, Strength around) {
    const Many all = relevant(given);
    if (areStated(all)) return bare(all, around);
    if (const auto made = madeOf(all)) return written(*made, around);
    isUneven_ = true;
    return {};
  }

  /// A number, which a power takes in parentheses where it has a sign.
  std::string bare(const Many& all, Strength around) const {
    const std::string text = numbers(all);
    return around == kAtom && text.front() != '(' && all.front().value < 0.0 ? "(" + text + ")" : text;
  }

  static std::string within(const std::string& text, Strength own, Strength around) {
    return own < around ? "(" + text + ")" : text;
  }

  std::string call(const std::string& function, const Made& made, std::size_t count = 1) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += (i == 0 ? "(" : ", ") + of(made.from[i], kSum);
    return function + text + ")";
  }

  /// max(a, b, c) of max(max(a, b), c), a of max(a, a).
  std::string extremes(const std::string& function, const Made& made, Strength around) {
    std::vector<std::string> all;
    addExtremes(made, all);
    if (all.size() == 1) return of(made.from[0], around);
    std::string text;
    for (const std::string& each : all) text += (text.empty() ? "(" : ", ") + each;
    return function + text + ")";
  }
  void addExtremes(const Made& made, std::vector<std::string>& out) {
    for (const std::size_t i : {0u, 1u}) {
      const Many all = relevant(made.from[i]);
      const auto inner = areStated(all) ? std::nullopt : madeOf(all);
      if (inner && inner->operation == made.operation) {
        addExtremes(*inner, out);
        continue;
      }
      std::string text = of(all, kSum);
      if (std::ranges::find(out, text) == out.end()) out.push_back(std::move(text)); // each once
    }
  }

  /// A difference that is added stands in parentheses.
  std::string summand(const Many& given) {
    const Many all = relevant(given);
    const auto made = areStated(all) ? std::nullopt : madeOf(all);
    return of(all, made && made->operation == Operation::Minus ? kProduct : kSum);
  }

  /// A literal has its own sign.
  std::string negative(const Many& given, Strength around) {
    if (!areLiteral(given)) return within("−" + of(given, kProduct), kProduct, around);
    Many all = given;
    for (Operand& x : all) x.value = -x.value;
    return bare(all, around);
  }

  std::string written(const Made& made, Strength around) {
    --left_;
    const Many &a = made.from[0], &b = made.from[1];
    switch (made.operation) {
    case Operation::Plus:
      return within(of(a, kSum) + " + " + summand(b), kSum, around);
    case Operation::Minus:
      if (isLiteral(relevant(a), 0.0)) return negative(b, around);
      return within(of(a, kSum) + " − " + of(b, kProduct), kSum, around);
    case Operation::Times:
      if (!areLiteral(a) && areSame(a, b)) return within(of(a, kAtom) + "^2", kPower, around);
      return within(of(a, kProduct) + " × " + of(b, kProduct), kProduct, around);
    case Operation::Over:
      return within(of(a, kProduct) + " / " + of(b, kPower), kProduct, around);
    case Operation::Negative:
      return negative(a, around);
    case Operation::Root:
      return call("√", made);
    case Operation::Absolute:
      return "|" + of(a, kSum) + "|";
    case Operation::Floor:
      return call("floor", made);
    case Operation::Min:
      return extremes("min", made, around);
    case Operation::Max:
      return extremes("max", made, around);
    case Operation::Clamp:
      return call("clamp", made, 3);
    case Operation::Smooth:
      return call("smooth", made);
    case Operation::Exp:
      return call("exp", made);
    case Operation::Cos:
      return call("cos", made);
    case Operation::Exp2:
      return within("2^" + of(a, kAtom), kPower, around);
    case Operation::Exp2LessOne:
      return within("2^" + of(a, kAtom) + " − 1", kSum, around);
    case Operation::Log2:
      return call("log₂", made);
    case Operation::Log2OfOnePlus:
      return "log₂(1 + " + of(a, kSum) + ")";
    case Operation::Log2OfRatio:
      return "log₂((1 + " + of(a, kSum) + ") / (1 − " + of(a, kProduct) + "))";
    case Operation::Power:
      return within(of(a, kAtom) + "^" + of(b, kAtom), kPower, around);
    case Operation::Rounded:
    case Operation::Read:
    case Operation::Setting:
    case Operation::Named:
      break;
    }
    return of(a, around);
  }

  const twin::Trace& trace_;
  FormulaStyle style_;
  std::unordered_set<std::uint32_t> stated_; ///< nodes that are written as a number: those of other rows
  std::vector<bool> isConstant_;             ///< by node: made of literals alone
  std::unordered_set<std::uint32_t> rows_;   ///< nodes of all other rows
  int left_ = kLongestFormula;               ///< operations that may be written as deep
  bool isUneven_ = false;                    ///< channels were made in different ways
};

} // namespace

bool isComputed(const twin::Trace& trace, IntermediateId id) {
  const auto channels = static_cast<std::size_t>(intermediate(id).channels);
  return std::ranges::any_of(std::span(trace.of(id)).first(channels), [&](const Operand& x) {
    if (x.node == 0) return false;
    const Operation operation = trace.at(x).operation;
    return operation != Operation::Read && operation != Operation::Setting;
  });
}

std::string formulaText(const twin::Trace& trace, IntermediateId id, int channel, const FormulaStyle& style) {
  return *Writer(trace, style, intermediate(id).stage)
              .text({trace.of(id)[static_cast<std::size_t>(channel)]}); // one is made as itself
}

std::optional<std::string> formulaText(const twin::Trace& trace, IntermediateId id,
                                       const FormulaStyle& style) {
  const auto channels = static_cast<std::size_t>(intermediate(id).channels);
  const auto all = std::span(trace.of(id)).first(channels);
  return Writer(trace, style, intermediate(id).stage).text(Many(all.begin(), all.end()));
}

std::optional<std::string> formulaText(const twin::Trace& trace, std::span<const Operand> channels,
                                       const FormulaStyle& style) {
  return Writer(trace, style, {}).text(Many(channels.begin(), channels.end()));
}

} // namespace taa::explanation
