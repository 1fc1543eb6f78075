// The probes, up to kMaxProbes of them; one is active. Each change goes to the render thread whole.
#pragma once

#include "app/session/ProbeList.h"

#include <QObject>
#include <QString>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace taa::app {

class Outbox;
class UndoStack;

class ProbeChoices : public QObject {
  Q_OBJECT
 public:
  /// `status` is that of the frame on show; it outlives this.
  ProbeChoices(Outbox& outbox, UndoStack& undo, const Status& status);

  const std::vector<Probe>& all() const { return probes_.all(); }
  int active() const { return probes_.active(); } ///< −1: there is none
  std::vector<ProbeMark> marks() const { return probes_.marks(); }
  /// Where the active probe is now.
  std::optional<glm::ivec2> pixel() const;
  /// What last arrived for the active probe, or for another; null: nothing yet.
  const ProbeResult* result() const { return probes_.result(probes_.active()); }
  const ProbeResult* result(int probe) const { return probes_.result(probe); }

  /// Whether the active probe's is of where it is set now.
  bool hasOwnResult() const { return probes_.hasOwnResult(probes_.active()); }
  /// Sets the active probe there, the first one when there is none; nothing: removes it.
  void setPixel(std::optional<glm::ivec2> pixel);
  void move(int dx, int dy);
  /// Sets another, which becomes active.
  void add(glm::ivec2 pixel, Follow follow = Follow::Screen);
  void remove(int probe);
  void removeAll();
  void setActive(int probe);
  /// What a probe stays on from now on; begins where it is now.
  void setFollow(int probe, Follow follow);
  /// Is no step of undo.
  void set(const std::vector<Probe>& probes, int active);
  /// Asks for the next one of the worst pixels by a row of the first lane (a WorstDelivery).
  void findWorst(IntermediateId row, WorstStep step = WorstStep::Pixel);
  /// Whether probes come with the active pixel under other choices.
  void setWhatIf(bool wanted);
  /// Whether a reference is drawn for the probes.
  void setReference(bool wanted);
  /// What the active pixel comes with the other side of; its row and style do not count.
  void setOtherSide(const std::optional<OtherSide>& other);

  // For the session
  /// The scene is another one: probes on its surfaces stay where they are.
  void forgetSurfaces();
  /// The picture may have become smaller.
  void keepInPicture();
  void arrived(std::vector<ProbeResult>&& results);

 Q_SIGNALS:
  void changed();      ///< a probe was set, removed, or made active
  void probeArrived(); ///< of at least one probe

 private:
  void post();
  void send();
  void change(const QString& what, const std::string& key, const std::function<bool()>& act);
  glm::ivec2 inPicture(glm::ivec2 pixel) const;

  Outbox& outbox_;
  UndoStack& undo_;
  const Status& status_;
  ProbeList probes_;
  bool wantsWhatIf_ = false, wantsReference_ = false;
  std::optional<OtherSide> other_;
};

} // namespace taa::app
