// How much the probed pixel moves with each sample, each texel of history and each number of the settings.
#pragma once

#include "core/requests/Results.h"

#include <QWidget>

#include <optional>

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

 private:
  ValueTable* table_;
};

} // namespace taa::app
