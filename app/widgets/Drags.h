// The drag of the mouse that is under way, wherever in the window, so that Esc can take it back.
#pragma once

#include <QObject>
#include <QPointer>

class QWidget;

namespace taa::app {

/// A widget whose drags change something that the undo stack does not know: where one looks, the frame.
class Draggable {
 public:
  virtual ~Draggable() = default;
  /// Puts back what the drag under way has moved, and forgets it.
  virtual void cancelDrag() = 0;
};

class Drags : public QObject {
 public:
  explicit Drags(QObject* parent);

  /// Whether a mouse button is down, on any widget.
  bool isRunning() const { return !pressed_.isNull(); }
  /// Takes it back as far as the undo stack does not; until the button is released nothing moves any more.
  void cancel();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QPointer<QWidget> pressed_;
  bool isCancelled_ = false;
};

} // namespace taa::app
