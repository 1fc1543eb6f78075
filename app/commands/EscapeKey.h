// What Esc ends: one thing at a time, the innermost of what is there.
#pragma once

#include <QElapsedTimer>
#include <QObject>

#include <optional>

namespace taa::app {

class Drags;
class Flight;
class Session;
class ViewArea;

enum class EscapeTarget { Drag, SearchText, SearchField, Work, Flight, Comparison, Probe };

/// What is there when the key comes.
struct EscapeState {
  bool isDragging = false;    ///< a mouse button is down
  bool hasSearchText = false; ///< in the search field that has the keys
  bool isInSearch = false;    ///< a search field has the keys
  bool isWorking = false;     ///< something long is under way, or was a moment ago: the key was meant for it
  bool isFlying = false;
  bool isComparing = false; ///< the active view
  bool hasProbe = false;
};

/// Popups, dialogs and numbers that are being typed get the key before the window. Then, in this order: a
/// drag is taken back, a text that is searched for is cleared, the search field is left, work is stopped, a
/// flight ends, the active view compares no more, the active probe is removed. Nothing: there is none of
/// these.
std::optional<EscapeTarget> escapeTarget(const EscapeState& state);

/// The key in the window.
class EscapeKey : public QObject {
  Q_OBJECT
 public:
  EscapeKey(Session& session, ViewArea& views, Flight& flight, QObject* parent);

  void press();

 private:
  EscapeState state() const;

  Session& session_;
  ViewArea& views_;
  Flight& flight_;
  Drags* drags_;
  QElapsedTimer workEnded_;
};

} // namespace taa::app
