// What a reader of nine digits makes of the formulas of a trace.
#pragma once

#include "core/explanation/FormulaText.h"
#include "core/settings/Settings.h"
#include "tests/support/Calculator.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace taa::test {

/// What storing takes from a color `value` that its formula leaves out.
inline double storedStep(IntermediateId id, double value, const Settings& settings) {
  if (id != IntermediateId::resolved) return 0.0;
  switch (settings.history.precision) {
  case Precision::Full:
    return 0.0;
  case Precision::Half:
    return 1e-3 * std::max(0.05, std::fabs(value));
  case Precision::Unorm8:
    return 1.0 / 255.0;
  case Precision::Unorm10:
    return 1.0 / 1023.0;
  }
  return 0.0;
}

/// The largest number that the value was made of; what a bound would have been that does not bind is none.
inline double largestOf(const twin::Trace& trace, const twin::Operand& value) {
  double largest = 0.0;
  std::vector<twin::Operand> left{value};
  std::set<std::uint32_t> seen;
  while (!left.empty()) {
    const twin::Operand x = left.back();
    left.pop_back();
    if (std::isfinite(x.value)) largest = std::max(largest, std::fabs(x.value));
    if (x.node == 0 || !seen.insert(x.node).second) continue;
    const twin::TraceNode& node = trace.at(x);
    const bool isBound = node.operation == twin::Operation::Min || node.operation == twin::Operation::Max ||
                         node.operation == twin::Operation::Clamp;
    for (const twin::Operand& from : node.from)
      if (!isBound || from.value == node.value) left.push_back(from);
  }
  return largest;
}

/// Nothing where the formula of the row's channel gives `value`, else what it gives. The resolve rounds each
/// step to 32 bits, and a spread is a small difference of large sums: to 1e-4, and some units of the last
/// place of the largest number in it.
inline std::optional<std::string> differenceOfFormula(const twin::Trace& trace, IntermediateId id,
                                                      int channel, double value, const Settings& settings,
                                                      FormulaDepth depth = FormulaDepth::Rows) {
  const std::string text = explanation::formulaText(trace, id, channel, {.digits = 9, .depth = depth});
  const double worked = Calculator(text).result().front();
  const double largest = largestOf(trace, trace.of(id)[static_cast<std::size_t>(channel)]);
  const double allowed =
      1e-4 * std::max(0.05, std::fabs(value)) + 2e-6 * largest + storedStep(id, value, settings);
  if (std::fabs(worked - value) <= allowed) return {};
  return text + " is " + std::to_string(worked) + ", not " + std::to_string(value);
}

} // namespace taa::test
