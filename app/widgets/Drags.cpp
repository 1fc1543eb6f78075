#include "app/widgets/Drags.h"

#include <QCoreApplication>
#include <QEvent>
#include <QWidget>

namespace taa::app {

Drags::Drags(QObject* parent) : QObject(parent) {
  QCoreApplication::instance()->installEventFilter(this);
}

void Drags::cancel() {
  for (QWidget* widget = pressed_; widget;
       widget = widget->parentWidget()) // a scroll area's are its viewport's
    if (auto* draggable = dynamic_cast<Draggable*>(widget)) {
      draggable->cancelDrag();
      break;
    }
  pressed_.clear();
  isCancelled_ = true;
}

// A press goes from a widget to its parents until one takes it, which then has the drag: the last one that
// saw it.
bool Drags::eventFilter(QObject* watched, QEvent* event) {
  const auto type = event->type();
  const bool isPress = type == QEvent::MouseButtonPress || type == QEvent::MouseButtonDblClick;
  if (isPress && watched->isWidgetType()) pressed_ = static_cast<QWidget*>(watched);
  if (type == QEvent::MouseButtonRelease) pressed_.clear();
  if (isPress || type == QEvent::MouseButtonRelease) isCancelled_ = false;
  return isCancelled_ && type == QEvent::MouseMove;
}

} // namespace taa::app
