// The pinned probes, up to kMaxPins of them; one is active. Each change goes to the render thread whole.
#pragma once

#include "app/session/Pins.h"

#include <QObject>
#include <QString>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace taa::app {

class Outbox;
class UndoStack;

class PinnedProbes : public QObject {
  Q_OBJECT
 public:
  /// `status` is that of the frame on show; it outlives this.
  PinnedProbes(Outbox& outbox, UndoStack& undo, const Status& status);

  const std::vector<ProbePin>& pins() const { return pins_.all(); }
  int activePin() const { return pins_.active(); } ///< −1: there is none
  std::vector<PinMark> pinMarks() const { return pins_.marks(); }
  /// Where the active pin is now.
  std::optional<glm::ivec2> pick() const;
  /// What last arrived for the active pin, or for another; null: nothing yet.
  const ProbeResult* probe() const { return pins_.result(pins_.active()); }
  const ProbeResult* probe(int pin) const { return pins_.result(pin); }

  /// Sets the active pin there, the first one when there is none; nothing: removes it.
  void setPick(std::optional<glm::ivec2> pixel);
  void movePick(int dx, int dy);
  /// Pins another, which becomes active.
  void addPin(glm::ivec2 pixel, Follow follow = Follow::Screen);
  void removePin(int pin);
  void removeAllPins();
  void setActivePin(int pin);
  /// What a pin stays on from now on; begins where it is now.
  void setFollow(int pin, Follow follow);
  /// Is no step of undo.
  void setPins(const std::vector<ProbePin>& pins, int active);
  /// Whether probes come with the active pixel under other choices.
  void setWhatIf(bool wanted);

  // For the session
  /// The scene is another one: pins on its surfaces stay where they are.
  void forgetSurfaces();
  /// The picture may have become smaller.
  void keepInPicture();
  void arrived(std::vector<ProbeResult>&& results);

 Q_SIGNALS:
  void pickChanged();  ///< a pin was set, removed, or made active
  void probeArrived(); ///< of at least one pin

 private:
  void send();
  void change(const QString& what, const std::string& key, const std::function<bool()>& act);
  glm::ivec2 inPicture(glm::ivec2 pixel) const;

  Outbox& outbox_;
  UndoStack& undo_;
  const Status& status_;
  Pins pins_;
  bool wantsWhatIf_ = false;
};

} // namespace taa::app
