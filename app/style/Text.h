// Text of the core as Qt's.
#pragma once

#include <QCoreApplication>
#include <QString>

#include <string_view>

namespace taa::app {

inline QString qtext(std::string_view utf8) {
  return QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()));
}

/// A text of the core's tables in the user's language: a label, unit or description, never an id.
inline QString tableText(std::string_view utf8) {
  const QByteArray text(utf8.data(), static_cast<qsizetype>(utf8.size()));
  return QCoreApplication::translate("tables", text.constData());
}

} // namespace taa::app
