#include "app/widgets/parameters/ChoiceWords.h"

#include <QRegularExpression>

#include <algorithm>

namespace taa::app {

QString withoutManual(const QString& text) {
  // "manual 11.3, 10.1" with what parts it from what comes next; what is left of its parentheses goes, too.
  static const QRegularExpression kCitation(
      QStringLiteral("manual ((§?\\d+(\\.\\d+)?[a-z]?|J\\d+)( to \\d+\\.\\d+)?(, )?)+[;:]?\\s*"));
  static const QRegularExpression kDefect(QStringLiteral("\\bD\\d+(?=[),]|$)(, )?"));
  static const QRegularExpression kEmpty(QStringLiteral("\\s*\\(\\s*\\)"));
  QString left = text;
  left.remove(kCitation).remove(kDefect);
  return left.remove(kEmpty).replace(QLatin1String("( "), QLatin1String("(")).trimmed();
}

QString briefly(const QString& explanation) {
  constexpr qsizetype kLongest = 72; // characters
  static const QRegularExpression kSources(QStringLiteral("\\s*\\([A-Z][^()]*\\)"));
  QString text = withoutManual(explanation).remove(kSources);
  for (const char* end : {". ", ": ", "; "})
    if (const qsizetype at = text.indexOf(QLatin1String(end)); at > 0 && text.size() > kLongest)
      text.truncate(at);
  if (text.size() > kLongest) {
    text.truncate(std::max<qsizetype>(1, text.lastIndexOf(QLatin1Char(' '), kLongest)));
    text += QStringLiteral(" …");
  }
  return text.endsWith(QLatin1Char('.')) ? text.chopped(1) : text;
}

bool isAsShipped(const Choice& choice) {
  return choice.label.ends_with(", as printed");
}

} // namespace taa::app
