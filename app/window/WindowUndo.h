// Makes steps of undo of what is changed in the views and on the timeline.
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

 private:
  StateWatch views_, timeline_;
};

} // namespace taa::app
