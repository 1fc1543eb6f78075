// Measures settings on a thread with an Inspector of its own, so that the window goes on drawing.
#pragma once

#include "app/background/LatestWork.h"
#include "core/sweep/ShotSweep.h"

#include <QObject>
#include <QString>

#include <functional>

namespace taa::app {

/// Lives on the UI thread, which never waits for it but at the end.
class SweepWork : public QObject {
  Q_OBJECT
 public:
  /// As sweepShot(); tests put another one in its place.
  using Sweep = std::function<void(const ShotSweepRequest&, const SettingsMeasured&, const Progress&)>;
  explicit SweepWork(Sweep sweep = sweepShot, QObject* parent = nullptr);
  ~SweepWork() override;

  /// Nothing of an earlier one arrives any more.
  void begin(const ShotSweepRequest& request);
  /// Nothing more arrives but ended().
  void cancel();
  bool isRunning() const { return isRunning_; }

 Q_SIGNALS:
  void progressed(const QString& what, int done, int total);
  void measured(std::size_t index, const LaneMetrics& frames);
  void ended(const QString& error); ///< empty: all was measured, or it was cancelled

 private:
  /// On the UI thread, unless another one has begun meanwhile.
  void deliver(int run, const std::function<void()>& act);
  void end(const QString& error);

  Sweep sweep_;
  int run_ = 0; ///< counts what was begun
  bool isRunning_ = false;
  LatestWork thread_; ///< last: it ends before the others go
};

} // namespace taa::app
