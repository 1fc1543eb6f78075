// The probes as numbered buttons, and what the active one follows.
#pragma once

#include "core/probe/Probe.h"

#include <QWidget>

#include <array>
#include <vector>

class QToolButton;

namespace taa::app {

class SegmentedButtons;

class ProbeBar : public QWidget {
  Q_OBJECT
 public:
  explicit ProbeBar(QWidget* parent = nullptr);

  void setProbes(const std::vector<Probe>& probes, int active);
  /// Disables to follow surfaces and says why; empty: they can be followed.
  void setWhyNoSurfaces(const QString& whyNot);
  QToolButton* button(int probe) const { return buttons_.at(static_cast<std::size_t>(probe)); }
  SegmentedButtons* follow() const { return follow_; }

 Q_SIGNALS:
  void probeChosen(int probe);
  void followChosen(Follow follow);

 private:
  std::array<QToolButton*, kMaxProbes> buttons_{};
  SegmentedButtons* follow_ = nullptr;
};

} // namespace taa::app
