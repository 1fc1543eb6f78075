#include "app/undo/StateWatch.h"

#include <QPointer>

#include <utility>

namespace taa::app {

StateWatch::StateWatch(UndoStack& stack, Part part, QObject* parent)
    : QObject(parent), stack_(stack), part_(std::move(part)), last_(part_.state()) {}

void StateWatch::look() {
  const QJsonObject before = std::exchange(last_, part_.state());
  if (stack_.isQuiet() || before == last_) return;
  const std::optional<ChangeName> name = part_.name(before, last_);
  if (!name) return;
  // The stack may outlive the window.
  const QPointer<StateWatch> self(this);
  UndoStep step = stepBackTo<QJsonObject>(
      before, [self] { return self ? self->part_.state() : QJsonObject(); },
      [self](const QJsonObject& state) {
        if (!self) return;
        self->part_.setState(state);
        self->look();
      });
  step.what = name->what;
  step.key = name->key;
  stack_.push(std::move(step));
}

} // namespace taa::app
