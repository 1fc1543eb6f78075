// Whether verdicts on the active probe are wanted, the latest one, and the remedies it names.
#pragma once

#include "core/requests/Results.h"

#include <QObject>

#include <cstddef>
#include <optional>
#include <vector>

namespace taa::app {

class Outbox;
class PresetChoices;
class ProbeChoices;

class VerdictChoices : public QObject {
  Q_OBJECT
 public:
  /// All of the same session; `status` is that of the frame on show.
  VerdictChoices(Outbox& outbox, const Status& status, const ProbeChoices& probes, PresetChoices& presets)
      : outbox_(outbox), status_(status), probes_(probes), presets_(presets) {}

  /// As somebody chose; at first they are.
  bool areOn() const { return isOn_; }
  void setOn(bool on);
  /// Whether somebody looks: none is made for nobody.
  void setShown(bool shown);

  /// Of the active probe in the frame on show, by the settings in force; null: on its way, or none is made.
  const VerdictDelivery* verdict() const;
  /// Nothing more is to come of the frame on show.
  bool isComplete() const;
  /// What corrects it, the best first; empty: nothing is known to, or not yet.
  const std::vector<TriedRemedy>& remedies() const;
  /// One step of undo, as if its settings had been set by hand. Expects that there is such a one.
  void apply(std::size_t remedy);

  // For the session
  void arrived(VerdictDelivery&& verdict);

 Q_SIGNALS:
  void changed();

 private:
  void send(bool wasWanted);
  bool isWanted() const { return isOn_ && isShown_; }

  Outbox& outbox_;
  const Status& status_;
  const ProbeChoices& probes_;
  PresetChoices& presets_;
  std::optional<VerdictDelivery> latest_;
  bool isOn_ = true, isShown_ = false;
};

} // namespace taa::app
