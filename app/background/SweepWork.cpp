#include "app/background/SweepWork.h"

#include "app/style/Text.h"
#include "core/base/Error.h"

#include <QMetaObject>

#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <exception>
#include <string>
#include <string_view>
#include <utility>

namespace taa::app {

namespace {

using SweepClock = std::chrono::steady_clock;
/// Progress is told so often at most: frames can be very short.
constexpr std::chrono::milliseconds kTellSweepEvery{100};
constexpr int kNice = 10;

/// Whoever draws the window comes first, where one processor does both.
void stepBack() {
  ::setpriority(PRIO_PROCESS, static_cast<::id_t>(::gettid()), kNice);
}

} // namespace

SweepWork::SweepWork(Sweep sweep, QObject* parent) : QObject(parent), sweep_(std::move(sweep)) {}
SweepWork::~SweepWork() = default;

void SweepWork::begin(const ShotSweepRequest& request) {
  isRunning_ = true;
  thread_.post([this, request, run = ++run_, sweep = sweep_](const LatestWork::IsWanted& isWanted) {
    stepBack();
    SweepClock::time_point told{};
    const Progress progress = [&](std::string_view what, int done, int total) {
      if (!isWanted()) return false;
      if (SweepClock::now() - told < kTellSweepEvery) return true;
      told = SweepClock::now();
      deliver(run, [this, text = qtext(what), done, total] { Q_EMIT progressed(text, done, total); });
      return true;
    };
    const auto known = [&](std::size_t index, const LaneMetrics& frames) {
      deliver(run, [this, index, frames] { Q_EMIT measured(index, frames); });
    };
    QString error;
    try {
      sweep(request, known, progress);
    } catch (const Cancelled&) { // what was measured is told
    } catch (const std::exception& failure) {
      error = QString::fromUtf8(failure.what());
    }
    deliver(run, [this, error] { end(error); });
  });
}

void SweepWork::cancel() {
  if (!isRunning_) return;
  thread_.cancel();
  ++run_;
  end({});
}

void SweepWork::deliver(int run, const std::function<void()>& act) {
  QMetaObject::invokeMethod(
      this,
      [this, run, act] {
        if (run == run_) act();
      },
      Qt::QueuedConnection);
}

void SweepWork::end(const QString& error) {
  isRunning_ = false;
  Q_EMIT ended(error);
}

} // namespace taa::app
