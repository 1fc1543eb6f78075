// Something long done on a thread with an Inspector of its own, so that the window goes on drawing.
#pragma once

#include "app/background/LatestWork.h"
#include "core/base/Progress.h"

#include <QObject>
#include <QString>

#include <functional>

namespace taa::app {

/// Lives on the UI thread, which never waits for it but at the end. What it finds is told by what it is given
/// to do, or by the signals of a subclass.
class BackgroundWork : public QObject {
  Q_OBJECT
 public:
  explicit BackgroundWork(QObject* parent = nullptr);
  ~BackgroundWork() override;

  /// Has something done on the UI thread, unless another one has begun meanwhile.
  using Deliver = std::function<void(const std::function<void()>& act)>;
  using Act = std::function<void(const Deliver& deliver, const Progress& progress)>;
  /// Nothing of an earlier one arrives any more.
  void start(const Act& act);
  /// Nothing more arrives but ended().
  void cancel();
  bool isRunning() const { return isRunning_; }

 Q_SIGNALS:
  void progressed(const QString& what, int done, int total);
  void ended(const QString& error); ///< empty: all was done, or it was cancelled

 private:
  void deliver(int run, const std::function<void()>& act);
  void end(const QString& error);

  int run_ = 0; ///< counts what was begun
  bool isRunning_ = false;
  LatestWork thread_; ///< last: it ends before the others go
};

} // namespace taa::app
