// A ring around the mouse that a whole room sees, with the value of the pixel under it.
#pragma once

#include <QString>
#include <QWidget>

namespace taa::app {

/// Lies over the window and lets the mouse through.
class PointerLabel : public QWidget {
  Q_OBJECT
 public:
  explicit PointerLabel(QWidget* window);
  /// `place` in the window; empty text: nothing is pointed at.
  void pointAt(QPoint place, const QString& text);
  const QString& text() const { return text_; }
  /// Where ring and text are, in the window.
  QRect ring() const;
  QRect words() const;

 protected:
  void paintEvent(QPaintEvent*) override;

 private:
  QPoint place_;
  QString text_;
};

} // namespace taa::app
