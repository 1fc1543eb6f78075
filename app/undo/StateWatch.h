// Makes undo of a part of the window that says its state as JSON: each change of it becomes a step.
#pragma once

#include "app/undo/UndoStack.h"

#include <QJsonObject>
#include <QObject>
#include <QString>

#include <functional>
#include <optional>
#include <string>

namespace taa::app {

/// What a change is called in the menu, and which changes it is one step with.
struct ChangeName {
  QString what;
  std::string key;
};

class StateWatch : public QObject {
  Q_OBJECT
 public:
  struct Part {
    std::function<QJsonObject()> state;
    std::function<void(const QJsonObject&)> setState;
    /// Nothing: it changed by itself.
    std::function<std::optional<ChangeName>(const QJsonObject& before, const QJsonObject& after)> name;
  };
  StateWatch(UndoStack& stack, Part part, QObject* parent);

  /// To be called after whatever may have changed it.
  void look();

 private:
  UndoStack& stack_;
  Part part_;
  QJsonObject last_;
};

} // namespace taa::app
