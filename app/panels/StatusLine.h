// The last line of the window: what lies under the mouse, how long the frame took, and whether it is exact.
#pragma once

#include "core/requests/Results.h"

#include <QString>
#include <QWidget>

#include <cstdint>

class QLabel;

namespace taa::app {

class ElidedLabel;

class StatusLine : public QWidget {
  Q_OBJECT
 public:
  explicit StatusLine(QWidget* parent = nullptr);

  /// Position and value under the mouse; empty: nothing there.
  void setHover(const QString& text);
  /// Whether injected faults are named; else it is said that there is one to be found.
  void setFaultsNamed(bool areNamed);
  void setStatus(const Status& status);
  /// Of which shot version there is a picture; see Status.
  void setPicture(std::uint64_t shotVersion);
  QString hover() const;
  QString badge() const; ///< empty: there is nothing to be said of a picture yet
  /// Whether the badge says that the picture is not what is wished for.
  bool showsBadge() const;

 protected:
  void changeEvent(QEvent*) override;

 private:
  enum class Badge { None, Exact, Caution };
  void refreshBadge();
  void show(Badge badge, const QString& text);
  void drawBadge();

  QLabel* hover_;
  ElidedLabel *driver_, *times_;
  QLabel* badgeIcon_;
  ElidedLabel* badge_;
  bool areFaultsNamed_ = true;
  Badge shown_ = Badge::None;
  Status status_;
  std::uint64_t shotVersion_ = 0; ///< of the newest picture
};

} // namespace taa::app
