// Numbers as text: exact for copying and probing, short for status lines.
#pragma once

#include <QString>

#include <span>

namespace taa::app {

/// The shortest decimal that reads back as the same float: "0.18431373", "-1e-05", "nan", "inf".
QString exactText(float value);
/// As exactText, with the sign as a minus of the width of a digit.
QString shownText(float value);
/// `digits` significant digits, with a typographic minus.
QString shortText(double value, int digits = 3);
/// `digits` decimals, with a typographic minus; 0 never has a sign.
QString fixedText(double value, int digits);
/// "(0.184, 0.22, 0.305)" or "0.184".
QString tupleText(std::span<const float> values, int digits = 4);
/// "< 0.1 %", "3.2 %", "45 %".
QString percentText(double percent);
/// Five significant digits, six decimals at most; "≈ 0" where nothing of a value is left, 0 never has a sign.
QString roundedText(float value);
/// A number padded so that `fraction` characters follow its whole part: in a column aligned to the right the
/// decimal points line up. Padded with spaces that do not break.
QString alignedText(const QString& number, int fraction);

} // namespace taa::app
