// What happened at a pixel, row by row: a line in words, the row's formula with the pixel's numbers put in,
// and which comparisons decided it.
#pragma once

#include "core/render/FrameInputs.h"
#include "core/settings/Settings.h"
#include "core/taa/twin/Details.h"
#include "core/taa/twin/Twin.h"

#include <cstdint>
#include <string>
#include <vector>

namespace taa {

/// A probed pixel with all that formulas are made of.
struct ProbedPixel {
  const twin::PixelRecord& record;
  const twin::Details& details;
  const Settings& settings; ///< that made it
  FrameInfo info;
  glm::ivec2 pixel{0};
};

/// What a formula is written down to.
enum class FormulaDepth : std::uint8_t {
  Rows,   ///< other rows, and values that the twin names: one line
  Stage,  ///< rows of other stages
  Samples ///< what was read: the nine samples, texels of history, settings
};

/// One row. The formula reads "expression = value", in plain arithmetic: + − × / ^ √( |…| min( max( clamp(x,
/// low, high) smooth( exp( log₂( floor( half(, and (a, b, c) for colors and positions. `subject` says
/// of what, where that is not the row's value as it stands: a channel, or a color before it goes back from
/// box space.
struct RowExplanation {
  std::string words;   ///< "history was pulled 31 % of the way",
  std::string formula; ///< empty where the row is read, set or searched for, or is what another row is
  std::string subject; ///< "Y"; empty: the row itself
  /// "depth mismatch 0.31 > depth allowed 0.02": which way the resolve went and why, as it came to it.
  std::vector<std::string> because;
};

/// `digits`: significant ones of every number.
RowExplanation explainRow(IntermediateId id, const ProbedPixel& probed,
                          FormulaDepth depth = FormulaDepth::Rows, int digits = 4);
/// "because …": the last five of them; empty where nothing was compared.
std::string becauseText(const RowExplanation& explanation);

} // namespace taa
