// The formula of a value, from how the twin made it.
#pragma once

#include "core/explanation/RowExplanation.h"
#include "core/taa/twin/Traced.h"

#include <optional>
#include <span>
#include <string>

namespace taa::explanation {

/// How rows are written: numbers have `digits` significant ones; of a row that is nothing but another one,
/// `unfolds` how that was made.
struct FormulaStyle {
  int digits = 4;
  bool unfolds = false;
  FormulaDepth depth = FormulaDepth::Rows;
};

/// How a channel of the row was made, with the numbers put in: as deep as the style says, and where that is
/// longer than kLongestFormula operations, from there on down to rows and to values that the twin names. In
/// the arithmetic of RowExplanation. Left out is what changes nothing: a factor of 1, a summand of 0, a clamp
/// and a bound by a literal that do not bind, and what storing the value does to it.
std::string formulaText(const twin::Trace& trace, IntermediateId id, int channel, const FormulaStyle& style);
inline constexpr int kLongestFormula = 1500;
/// Whether the row was computed from something: it is no literal, nor just read, set or another row (which α
/// is told through).
bool isComputed(const twin::Trace& trace, IntermediateId id);
/// That of all channels at once; nothing where they were not made alike.
std::optional<std::string> formulaText(const twin::Trace& trace, IntermediateId id,
                                       const FormulaStyle& style);
/// Of values of the trace that are no row.
std::optional<std::string> formulaText(const twin::Trace& trace, std::span<const twin::Operand> channels,
                                       const FormulaStyle& style);

} // namespace taa::explanation
