#include "app/window/WindowUndo.h"

#include "app/panels/TimelinePanel.h"
#include "app/undo/DocumentChanges.h"
#include "app/views/ViewArea.h"
#include "app/widgets/SearchField.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>

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
  qApp->installEventFilter(this);
  connect(&views, &ViewArea::shownChanged, &views_, &StateWatch::look);
  connect(&timeline, &TimelinePanel::playbackEdited, &timeline_, &StateWatch::look);
  connect(&timeline, &TimelinePanel::marksChanged, &timeline_, &StateWatch::look);
  connect(&timeline, &TimelinePanel::loopToggled, &timeline_, &StateWatch::look);
  connect(&timeline, &TimelinePanel::metricChosen, &timeline_, &StateWatch::look);
}

// Number fields of Qt keep these keys to themselves, also where there is nothing of theirs to take back.
bool WindowUndo::eventFilter(QObject* object, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride) return false;
  const auto* key = static_cast<const QKeyEvent*>(event);
  if (!isUndoKey(*key) || !qobject_cast<QAbstractSpinBox*>(object)) return false;
  const auto* field = object->findChild<QLineEdit*>();
  const bool isRedo = key->modifiers().testFlag(Qt::ShiftModifier);
  if (field->isModified() && (isRedo ? field->isRedoAvailable() : field->isUndoAvailable())) return false;
  event->ignore();
  return true;
}

} // namespace taa::app
