// Looks for better settings beside the window.
#pragma once

#include "app/background/BackgroundWork.h"
#include "core/sweep/tune/ShotTune.h"

#include <functional>

namespace taa::app {

class TuneWork : public BackgroundWork {
  Q_OBJECT
 public:
  /// As tuneShot(); tests put another one in its place.
  using Tune = std::function<void(const ShotTuneRequest&, const TuneTold&, const Progress&)>;
  explicit TuneWork(Tune tune = tuneShot, QObject* parent = nullptr);

  void begin(const ShotTuneRequest& request);

 Q_SIGNALS:
  void told(const TuneWay& way);

 private:
  Tune tune_;
};

} // namespace taa::app
