// Measures settings beside the window.
#pragma once

#include "app/background/BackgroundWork.h"
#include "core/sweep/ShotSweep.h"

#include <cstddef>
#include <functional>

namespace taa::app {

class SweepWork : public BackgroundWork {
  Q_OBJECT
 public:
  /// As sweepShots(); tests put another one in its place.
  using Sweep = std::function<void(const ShotSweepRequest&, const SettingsMeasured&, const Progress&)>;
  explicit SweepWork(Sweep sweep = sweepShots, QObject* parent = nullptr);

  void begin(const ShotSweepRequest& request);

 Q_SIGNALS:
  void measured(std::size_t index, const LaneMetrics& frames);

 private:
  Sweep sweep_;
};

} // namespace taa::app
