#include "app/learn/RightArea.h"

#include <QEvent>

namespace taa::app {

RightArea::RightArea(QWidget* lesson, QWidget* probe, QWidget* parent) : QSplitter(Qt::Vertical, parent) {
  setHandleWidth(1);
  setChildrenCollapsible(false);
  for (QWidget* part : {lesson, probe}) {
    addWidget(part);
    part->installEventFilter(this);
  }
}

// Parts are shown and hidden by whoever has them.
bool RightArea::eventFilter(QObject* part, QEvent* event) {
  if (event->type() == QEvent::ShowToParent || event->type() == QEvent::HideToParent) follow();
  return QSplitter::eventFilter(part, event);
}

void RightArea::follow() {
  bool isEmpty = true;
  for (int index = 0; index < count(); ++index) isEmpty = isEmpty && widget(index)->isHidden();
  setVisible(!isEmpty);
  if (!widget(0)->isHidden() && !widget(1)->isHidden()) setSizes({height() / 2, height() / 2});
}

} // namespace taa::app
