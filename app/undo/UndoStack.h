// Undo and redo of what is open, in the order in which it was changed: settings, probes, cameras, objects,
// views, marks. What a session file keeps is part of it, but where one looks and what lies around: frame,
// zoom, panels.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace taa::app {

struct UndoStep {
  QString what;    ///< as the menu names it: "move probe"
  std::string key; ///< changes of one key in a row are one step while a gesture lasts; empty: never
  /// Puts what was there before in place of what is there now, and keeps that.
  std::function<void()> exchange;
  /// Whether both are the same, so that there is nothing to take back; null: not known.
  std::function<bool()> isVoid{};
  bool ofScene = false; ///< means nothing once another scene is open
};

/// The step back to `before`. `capture` says the state of now, `apply` sets one.
template <class State>
UndoStep stepBackTo(State before, std::function<State()> capture, std::function<void(const State&)> apply) {
  const auto kept = std::make_shared<State>(std::move(before)); // its second owner is the question
  UndoStep step;
  step.exchange = [kept, capture, apply] {
    State now = capture();
    apply(*kept);
    *kept = std::move(now);
  };
  step.isVoid = [kept, capture] { return capture() == *kept; };
  return step;
}

/// A gesture is a press of the mouse until its release, or keys and turns of the wheel that follow each other
/// soon.
class UndoStack : public QObject {
  Q_OBJECT
 public:
  explicit UndoStack(QObject* parent = nullptr);

  /// Notes a change that was just made; nothing while it is quiet. What was undone before can then not be
  /// done again.
  void push(UndoStep step);
  bool canUndo() const { return !undo_.empty(); }
  bool canRedo() const { return !redo_.empty(); }
  QString undoText() const; ///< what undo() takes back; empty: nothing
  QString redoText() const;
  void undo();
  void redo();
  /// What follows is a step of its own. A gesture that led back to where it began leaves none.
  void endGesture();
  /// Takes back what the gesture under way has changed, as if it had not begun.
  void abandonGesture();
  void forgetScene(); ///< drops the steps that are of the scene
  void clear();

  /// While one of these lives changes are not noted: they are of undo itself, or of a file that is opened.
  class Quiet {
   public:
    explicit Quiet(UndoStack& stack) : stack_(stack) { ++stack_.quiet_; }
    ~Quiet() { --stack_.quiet_; }
    Quiet(const Quiet&) = delete;
    Quiet& operator=(const Quiet&) = delete;

   private:
    UndoStack& stack_;
  };
  bool isQuiet() const { return quiet_ > 0; }

 Q_SIGNALS:
  void changed(); ///< what can be undone or redone

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool dropIfVoid();
  void move(std::vector<UndoStep>& from, std::vector<UndoStep>& to);

  std::vector<UndoStep> undo_, redo_;
  std::vector<UndoStep> redoBefore_; ///< what could be done again before the step that is open
  bool isOpen_ = false;              ///< the last step goes on with the gesture
  bool isPressed_ = false;           ///< the mouse
  int quiet_ = 0;
  QTimer pause_; ///< runs out when keys and wheel have rested
};

} // namespace taa::app
