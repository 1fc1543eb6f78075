#include "app/window/WindowUndo.h"

#include "app/panels/TimelinePanel.h"
#include "app/undo/DocumentChanges.h"
#include "app/views/ViewArea.h"

namespace taa::app {

WindowUndo::WindowUndo(UndoStack& stack, ViewArea& views, TimelinePanel& timeline)
    : views_(stack,
             {[&views] { return documentOfViews(views.state()); },
              [&views](const QJsonObject& part) { views.setState(withPlacesOf(views.state(), part)); },
              viewChange},
             nullptr),
      timeline_(stack,
                {[&timeline] { return timeline.state(); },
                 [&timeline](const QJsonObject& part) { timeline.setState(part); }, timelineChange},
                nullptr) {
  connect(&views, &ViewArea::shownChanged, &views_, &StateWatch::look);
  connect(&timeline, &TimelinePanel::playbackEdited, &timeline_, &StateWatch::look);
  connect(&timeline, &TimelinePanel::marksChanged, &timeline_, &StateWatch::look);
  connect(&timeline, &TimelinePanel::loopToggled, &timeline_, &StateWatch::look);
  connect(&timeline, &TimelinePanel::metricChosen, &timeline_, &StateWatch::look);
}

} // namespace taa::app
