// A line between two parts of the window, one pixel thick.
#pragma once

#include <QWidget>

namespace taa::app {

class Line : public QWidget {
 public:
  explicit Line(QWidget* parent = nullptr) : QWidget(parent) {
    setFixedHeight(1);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Mid);
  }
};

} // namespace taa::app
