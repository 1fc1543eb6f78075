// On or off, as a small switch.
#pragma once

#include <QAbstractButton>

namespace taa::app {

class Toggle : public QAbstractButton {
  Q_OBJECT
 public:
  explicit Toggle(QWidget* parent = nullptr);
  void setDimmed(bool dimmed);
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent*) override;
  void keyPressEvent(QKeyEvent*) override;

 private:
  bool dimmed_ = false;
};

} // namespace taa::app
