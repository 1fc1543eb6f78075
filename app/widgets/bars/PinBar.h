// The pinned probes as numbered buttons, and what the active one follows.
#pragma once

#include "core/probe/ProbePin.h"

#include <QWidget>

#include <array>
#include <vector>

class QToolButton;

namespace taa::app {

class SegmentedButtons;

class PinBar : public QWidget {
  Q_OBJECT
 public:
  explicit PinBar(QWidget* parent = nullptr);

  void setPins(const std::vector<ProbePin>& pins, int active);
  /// Disables to follow surfaces and says why; empty: they can be followed.
  void setWhyNoSurfaces(const QString& whyNot);
  QToolButton* button(int pin) const { return buttons_.at(static_cast<std::size_t>(pin)); }
  SegmentedButtons* follow() const { return follow_; }

 Q_SIGNALS:
  void pinChosen(int pin);
  void followChosen(Follow follow);

 private:
  std::array<QToolButton*, kMaxPins> buttons_{};
  SegmentedButtons* follow_ = nullptr;
};

} // namespace taa::app
