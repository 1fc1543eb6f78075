// Checks every intermediate of all presets on this machine's driver, and shows what came out as a table to
// send with a report.
#pragma once

#include "app/background/BackgroundWork.h"
#include "app/background/WorkDialog.h"
#include "core/inspect/DriverCheck.h"

#include <QString>

#include <functional>
#include <optional>

class QPushButton;
class QTreeWidget;

namespace taa::app {

class BackgroundBar;

/// There is one of a window: what was found is there again when it is opened again.
class VerifyDialog : public WorkDialog {
  Q_OBJECT
 public:
  /// As checkDriver(); tests put another one in its place.
  using Check = std::function<DriverCheck(const Progress&)>;
  explicit VerifyDialog(QWidget* parent, Check check = checkDriver);

  /// Opens that of `window`, or brings it to the front.
  static void openAt(QWidget* window);

  QTreeWidget* rows() const { return rows_; }
  BackgroundBar* bar() const { return bar_; }
  void begin();
  /// What `taa-batch verify --json` says of the driver; empty: nothing was checked.
  QString text() const;

 private:
  void showCheck(const DriverCheck& check);
  void finish(const QString& error);

  Check make_;
  BackgroundWork work_;
  std::optional<DriverCheck> check_;
  QTreeWidget* rows_;
  BackgroundBar* bar_;
  QPushButton* copy_;
};

} // namespace taa::app
