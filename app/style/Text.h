// Text of the core as Qt's.
#pragma once

#include <QString>
#include <QStringList>

#include <string>
#include <string_view>
#include <vector>

namespace taa::app {

inline QString qtext(std::string_view utf8) {
  return QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()));
}

/// A clause of the core as a sentence: with a capital and a full stop, which it may have already.
inline QString sentence(std::string_view clause) {
  QString text = qtext(clause);
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text.endsWith(QLatin1Char('.')) ? text : text + QLatin1Char('.');
}

/// Clauses of the core in one row.
inline QString clauses(const std::vector<std::string>& all) {
  QStringList texts;
  for (const std::string& clause : all) texts << qtext(clause);
  return texts.join(QLatin1String("; "));
}

} // namespace taa::app
