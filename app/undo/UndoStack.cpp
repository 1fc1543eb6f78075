#include "app/undo/UndoStack.h"

#include <QCoreApplication>
#include <QEvent>

#include <algorithm>
#include <cstddef>

namespace taa::app {

namespace {

constexpr int kPauseMs = 800;
constexpr std::size_t kMaxSteps = 500;

} // namespace

UndoStack::UndoStack(QObject* parent) : QObject(parent) {
  pause_.setParent(this); // found by tests
  pause_.setSingleShot(true);
  pause_.setInterval(kPauseMs);
  connect(&pause_, &QTimer::timeout, this, [this] {
    if (!isPressed_) endGesture();
  });
  if (QCoreApplication::instance()) QCoreApplication::instance()->installEventFilter(this);
}

void UndoStack::push(UndoStep step) {
  if (isQuiet()) return;
  pause_.start();
  if (isOpen_ && !step.key.empty() && step.key == undo_.back().key)
    return; // it goes back to before the first
  endGesture();
  redoBefore_ = std::exchange(redo_, {});
  undo_.push_back(std::move(step));
  if (undo_.size() > kMaxSteps) undo_.erase(undo_.begin());
  isOpen_ = true;
  Q_EMIT changed();
}

QString UndoStack::undoText() const {
  return undo_.empty() ? QString() : undo_.back().what;
}

QString UndoStack::redoText() const {
  return redo_.empty() ? QString() : redo_.back().what;
}

void UndoStack::move(std::vector<UndoStep>& from, std::vector<UndoStep>& to) {
  if (from.empty()) return;
  UndoStep step = std::move(from.back());
  from.pop_back();
  {
    const Quiet quiet(*this);
    step.exchange();
  }
  to.push_back(std::move(step));
  Q_EMIT changed();
}

void UndoStack::undo() {
  endGesture();
  move(undo_, redo_);
}

void UndoStack::redo() {
  endGesture();
  move(redo_, undo_);
}

// Whether the step that is open was one of nothing.
bool UndoStack::dropIfVoid() {
  if (!isOpen_ || !undo_.back().isVoid || !undo_.back().isVoid()) return false;
  undo_.pop_back();
  redo_ = std::exchange(redoBefore_, {});
  return true;
}

void UndoStack::endGesture() {
  const bool dropped = dropIfVoid();
  isOpen_ = false;
  redoBefore_.clear();
  if (dropped) Q_EMIT changed();
}

void UndoStack::abandonGesture() {
  if (!isOpen_) return;
  UndoStep step = std::move(undo_.back());
  undo_.pop_back();
  redo_ = std::exchange(redoBefore_, {});
  isOpen_ = false;
  {
    const Quiet quiet(*this);
    step.exchange();
  }
  Q_EMIT changed();
}

void UndoStack::forgetScene() {
  endGesture();
  for (auto* steps : {&undo_, &redo_})
    std::erase_if(*steps, [](const UndoStep& step) { return step.ofScene; });
  Q_EMIT changed();
}

void UndoStack::clear() {
  isOpen_ = false;
  undo_.clear();
  redo_.clear();
  redoBefore_.clear();
  Q_EMIT changed();
}

bool UndoStack::eventFilter(QObject* watched, QEvent* event) {
  const auto type = event->type();
  const bool isPress = type == QEvent::MouseButtonPress || type == QEvent::MouseButtonDblClick;
  if (watched->isWidgetType() && (isPress || type == QEvent::MouseButtonRelease)) {
    isPressed_ = isPress;
    endGesture();
  }
  return false;
}

} // namespace taa::app
