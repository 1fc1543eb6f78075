// The column right of the views: a lesson where one is read, and the probe below it.
#pragma once

#include <QSplitter>

namespace taa::app {

/// Hidden while both of its parts are.
class RightArea : public QSplitter {
  Q_OBJECT
 public:
  RightArea(QWidget* lesson, QWidget* probe, QWidget* parent = nullptr);

 protected:
  bool eventFilter(QObject* part, QEvent* event) override;

 private:
  void follow();
};

} // namespace taa::app
