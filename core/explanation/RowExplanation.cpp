#include "core/explanation/RowExplanation.h"

#include "core/base/Say.h"
#include "core/explanation/Decisions.h"
#include "core/explanation/RowFormatter.h"
#include "core/explanation/RowsOff.h"
#include "core/taa/twin/Known.h"

#include <utility>

namespace taa {

namespace {

/// Why there is nothing to tell of the row; empty: there is.
std::string absenceWords(IntermediateId id, const ProbedPixel& probed) {
  if (isRowOff(id, probed.settings)) return say<"off">();
  if (isOfHistory(id) && probed.details.isFirst) return say<"there is no history yet">();
  if (!isOfReference(id) || twin::isKnown(probed.record, id)) return {};
  return isOverTime(id)   ? say<"it is not measured yet">()
         : isOfEngine(id) ? say<"there is no output of an engine">()
                          : say<"there is no reference yet">();
}

} // namespace

RowExplanation explainRow(IntermediateId id, const ProbedPixel& whole, FormulaDepth depth, int digits) {
  Settings settings = whole.settings;
  if (!isTaaOn(settings)) settings.output = {}; // nothing of it is done
  const ProbedPixel probed{whole.record, whole.details, settings, whole.info, whole.pixel};
  if (std::string why = absenceWords(id, probed); !why.empty()) return {std::move(why), "", "", {}};
  const explanation::RowFormatter formatter{probed, digits, depth};
  const auto [formula, subject] = explanation::rowFormula(id, formatter);
  std::string words = explanation::rowWords(id, formatter);
  if (words.empty()) words = intermediate(id).description;
  RowExplanation out{std::move(words), formula, subject, {}};
  if (const auto& trace = probed.details.trace)
    out.because = explanation::decisionTexts(*trace, id, whole.settings, digits);
  return out;
}

std::string becauseText(const RowExplanation& explanation) {
  constexpr std::size_t kMost = 5;
  const std::size_t count = explanation.because.size();
  std::string text;
  for (std::size_t i = count < kMost ? 0 : count - kMost; i < count; ++i)
    text += (text.empty() ? "" : ", ") + explanation.because[i];
  return text.empty() ? text : say<"because %1">(text);
}

} // namespace taa
