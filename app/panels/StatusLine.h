// The last line of the window: what lies under the mouse, how long the frame took, and whether it is exact.
#pragma once

#include "core/RenderThread.h"

#include <QWidget>

class QLabel;

namespace taa::app {

class StatusLine : public QWidget {
  Q_OBJECT
 public:
  explicit StatusLine(QWidget* parent = nullptr);

  /// Position and value under the mouse; empty: nothing there.
  void setHover(const QString& text);
  void setStatus(const Status& status);
  QString hover() const;
  /// Whether the badge says that the picture is not what is wished for.
  bool showsBadge() const;

 private:
  void refreshBadge(const QString& caution);

  QLabel *hover_, *driver_, *times_, *badgeIcon_, *badge_;
  QString caution_; ///< empty: none
};

} // namespace taa::app
