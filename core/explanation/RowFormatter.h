// Numbers and expressions of the explanations, as text; for the files of RowExplanation, and numbers of
// other sentences.
#pragma once

#include "core/base/NumberText.h"
#include "core/explanation/RowExplanation.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <string>
#include <string_view>

namespace taa::explanation {

using Id = IntermediateId;

/// Of `digits` significant ones each.
std::string tupleText(const glm::vec2& v, int digits = 4);
std::string tupleText(const glm::vec3& v, int digits = 4);
/// "31.4 %"
std::string percentText(double share);
/// α without what is asked for because history was rejected.
float alphaBeforeRejection(const twin::PixelRecord& record);
/// Where the way leads that the clip amount is a share of: "the middle of the box".
std::string targetText(RectifyMethod method);
/// How many frames of the reference rate a step counts as (manual 13.19): eighths, 1/8 to 8.
double framesTaken(double stepSeconds, const WeightSettings& weight);
/// Label of the choice that the settings have.
std::string choiceLabel(std::string_view path, const Settings& settings);

/// The pixel, and how its numbers are written.
struct RowFormatter {
  const ProbedPixel& probed;
  int digits = 4;
  FormulaDepth depth = FormulaDepth::Rows; ///< of formulas

  float value(Id id) const { return twin::at(probed.record, id).x; }
  glm::vec2 pair(Id id) const { return glm::vec2(twin::at(probed.record, id)); }
  glm::vec3 color(Id id) const { return glm::vec3(twin::at(probed.record, id)); }
  const Settings& settings() const { return probed.settings; }
  const twin::Details& details() const { return probed.details; }

  std::string number(double x) const { return numberText(x, digits); }
  std::string number(float x) const { return number(static_cast<double>(x)); }
  std::string number(Id id) const { return number(value(id)); }
  std::string tuple(const glm::vec2& v) const { return tupleText(v, digits); }
  std::string tuple(const glm::vec3& v) const { return tupleText(v, digits); }
  std::string percent(Id id) const { return percentText(static_cast<double>(value(id))); }
  /// "expression = value"
  std::string equals(const std::string& expression, Id id) const;
};

/// What is special about the row at this pixel; empty: nothing but what the table says of it.
std::string rowWords(Id id, const RowFormatter& formatter);

/// A formula, and of what.
struct RowFormula {
  std::string text;
  std::string subject;
};
/// How the twin made the row, or, of rows that it does not make, what they are a difference of; empty where
/// the row is read, set or chosen, or is what another row is.
RowFormula rowFormula(Id id, const RowFormatter& formatter);

/// The color as it is mixed, before it is stored.
glm::vec3 mixedColor(const RowFormatter& formatter);
/// `words`, and what storing the color does to it.
std::string storedWords(const RowFormatter& formatter, const std::string& words);
/// An expression of the color, or of one channel of it, as it is stored: rounded.
std::string storedText(const RowFormatter& formatter, const std::string& expression, int channel = -1);
/// Whether each channel is mixed by its own α.
bool isMixedPerChannel(const RowFormatter& formatter);
/// Whether nothing of history is in the color.
bool isCurrentAlone(const RowFormatter& formatter);
/// Whether the correction moved history, or would have with all of it.
bool isMoved(const RowFormatter& formatter);

} // namespace taa::explanation
