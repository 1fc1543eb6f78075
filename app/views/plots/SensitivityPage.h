// How much the probed pixel moves with each sample, each texel of history and each number of the settings.
#pragma once

#include "core/requests/Results.h"

#include <QWidget>

#include <optional>
#include <string_view>
#include <vector>

namespace taa::app {

class ValueTable;

class SensitivityPage : public QWidget {
  Q_OBJECT
 public:
  explicit SensitivityPage(QWidget* parent = nullptr);

  void setResult(const std::optional<ProbeResult>& result);
  ValueTable* table() const { return table_; }
  /// The table, to copy.
  QString text() const;

 Q_SIGNALS:
  /// Where over the picture a number of the settings matters is asked for.
  void mapRequested(const QString& path);

 private:
  /// The number of a line; empty: it is none.
  QString pathAt(int line) const;

  ValueTable* table_;
  std::vector<std::string_view> paths_; ///< of the table's lines
};

} // namespace taa::app
