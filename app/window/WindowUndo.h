// Makes steps of undo of what is changed in the views and on the timeline, and has the keys of undo reach the
// window wherever the focus is.
#pragma once

#include "app/undo/StateWatch.h"

#include <QObject>

namespace taa::app {

class TimelinePanel;
class ViewArea;

class WindowUndo : public QObject {
  Q_OBJECT
 public:
  WindowUndo(UndoStack& stack, ViewArea& views, TimelinePanel& timeline);

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  StateWatch views_, timeline_;
};

} // namespace taa::app
