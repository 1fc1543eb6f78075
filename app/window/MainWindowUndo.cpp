// The window's part in undo, and what Esc ends.
#include "app/menus/Menus.h"
#include "app/panels/TimelinePanel.h"
#include "app/session/DocumentChanges.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "app/widgets/Drags.h"
#include "app/widgets/SearchField.h"
#include "app/window/EscapeKey.h"
#include "app/window/Flight.h"
#include "app/window/MainWindow.h"

#include <QApplication>

#include <optional>
#include <utility>

namespace taa::app {

namespace {

/// A key that was to stop some work may come when it has just ended.
constexpr qint64 kLateMs = 400;

} // namespace

void MainWindow::connectUndo() {
  drags_ = new Drags(this);
  UndoStack& stack = session_.undoStack();
  viewsWatch_ = new StateWatch(
      stack,
      {[this] { return documentOfViews(views_->state()); },
       [this](const QJsonObject& part) { views_->setState(withPlacesOf(views_->state(), part)); },
       viewChange},
      this);
  connect(views_, &ViewArea::shownChanged, viewsWatch_, &StateWatch::look);
  timelineWatch_ =
      new StateWatch(stack,
                     {[this] { return timeline_->state(); },
                      [this](const QJsonObject& part) { timeline_->setState(part); }, timelineChange},
                     this);
  connect(timeline_, &TimelinePanel::playbackEdited, timelineWatch_, &StateWatch::look);
  connect(timeline_, &TimelinePanel::marksChanged, timelineWatch_, &StateWatch::look);
  connect(timeline_, &TimelinePanel::loopToggled, timelineWatch_, &StateWatch::look);
  connect(timeline_, &TimelinePanel::figureChosen, timelineWatch_, &StateWatch::look);
  connect(&stack, &UndoStack::changed, this, [this] { menus_->refresh(); });
  connect(&session_, &Session::workChanged, this, [this, wasWorking = false]() mutable {
    const bool isWorking = !session_.work().what.empty();
    if (std::exchange(wasWorking, isWorking) && !isWorking) workEnded_.start();
  });
}

EscapeState MainWindow::escapeState() const {
  const auto* search = qobject_cast<const SearchField*>(QApplication::focusWidget());
  const bool justWorked = workEnded_.isValid() && workEnded_.elapsed() < kLateMs;
  return {.isDragging = drags_->isRunning(),
          .hasSearchText = search && !search->text().isEmpty(),
          .isInSearch = search != nullptr,
          .isWorking = justWorked || !session_.work().what.empty() || session_.status().goal,
          .isFlying = flight_->isOn(),
          .isComparing = static_cast<bool>(views_->active()->comparison()),
          .hasProbe = session_.activePin() >= 0};
}

void MainWindow::escape() {
  const std::optional<EscapeTarget> target = escapeTarget(escapeState());
  if (!target) return;
  switch (*target) {
  case EscapeTarget::Drag:
    drags_->cancel();
    return session_.undoStack().abandonGesture();
  case EscapeTarget::SearchText:
    return static_cast<SearchField*>(QApplication::focusWidget())->clear();
  case EscapeTarget::SearchField:
    return views_->active()->viewport()->setFocus();
  case EscapeTarget::Work:
    return session_.cancel();
  case EscapeTarget::Flight:
    return flight_->setOn(false);
  case EscapeTarget::Comparison:
    return views_->active()->setComparison({});
  case EscapeTarget::Probe:
    return session_.setPick({});
  }
}

} // namespace taa::app
