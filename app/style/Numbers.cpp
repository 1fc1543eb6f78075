#include "app/style/Numbers.h"

#include "core/base/NumberText.h"

#include <QObject>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace taa::app {

namespace {

QString withMinus(QString text) {
  return text.replace(QLatin1Char('-'), QChar(0x2212));
}

/// Characters before the decimal point or exponent.
qsizetype wholeLength(const QString& text) {
  const auto isEnd = [](QChar c) { return c == QLatin1Char('.') || c == QLatin1Char('e'); };
  return std::find_if(text.begin(), text.end(), isEnd) - text.begin();
}

} // namespace

QString exactText(float value) {
  return QString::fromStdString(shortestText(value));
}

QString shownText(float value) {
  return withMinus(exactText(value));
}

QString shortText(double value, int digits) {
  return withMinus(QString::number(value == 0 ? 0.0 : value, 'g', digits));
}

QString fixedText(double value, int digits) {
  const bool isZero = std::abs(value) < 0.5 * std::pow(10.0, -digits);
  return withMinus(QString::number(isZero ? 0.0 : value, 'f', digits));
}

QString tupleText(std::span<const float> values, int digits) {
  QStringList texts;
  for (const float value : values) texts << shortText(value, digits);
  return texts.size() == 1 ? texts[0] : QStringLiteral("(%1)").arg(texts.join(QStringLiteral(", ")));
}

QString roundedText(float value) {
  constexpr int kDigits = 5, kMostDecimals = 6;
  if (!std::isfinite(value) || std::abs(value) >= 1e9f) return shortText(static_cast<double>(value), kDigits);
  if (value == 0.0f) return QStringLiteral("0");
  if (std::abs(value) < 0.5e-6f) return QStringLiteral("≈ 0");
  const int before = static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
  const int decimals = std::clamp(kDigits - before, 0, kMostDecimals);
  QString text = QString::number(static_cast<double>(value), 'f', decimals);
  if (decimals > 0) text.remove(QRegularExpression(QStringLiteral("\\.?0+$")));
  return withMinus(text);
}

QString alignedText(const QString& number, int fraction) {
  const qsizetype after = number.size() - wholeLength(number);
  return number + QString(std::max<qsizetype>(0, fraction - after), QChar(QChar::Nbsp));
}

QString percentText(double percent) {
  if (percent > 0 && percent < 0.1) return QObject::tr("< 0.1 %");
  return QObject::tr("%1 %").arg(percent, 0, 'f', percent < 10 ? 1 : 0);
}

} // namespace taa::app
