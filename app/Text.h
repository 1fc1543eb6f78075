// Text of the core as Qt's.
#pragma once

#include <QString>

#include <string_view>

namespace taa::app {

inline QString qtext(std::string_view utf8) {
  return QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()));
}

} // namespace taa::app
