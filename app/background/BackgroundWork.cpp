#include "app/background/BackgroundWork.h"

#include "app/style/Text.h"
#include "core/base/Error.h"
#include "core/base/ShownText.h"

#include <QMetaObject>

#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <exception>
#include <string_view>

namespace taa::app {

namespace {

using WorkClock = std::chrono::steady_clock;
/// Progress is told so often at most: frames can be very short.
constexpr std::chrono::milliseconds kTellWorkEvery{100};
constexpr int kNice = 10;

/// Whoever draws the window comes first, where one processor does both.
void stepBack() {
  ::setpriority(PRIO_PROCESS, static_cast<::id_t>(::gettid()), kNice);
}

} // namespace

BackgroundWork::BackgroundWork(QObject* parent) : QObject(parent) {}
BackgroundWork::~BackgroundWork() = default;

void BackgroundWork::start(const Act& act) {
  isRunning_ = true;
  thread_.post([this, act, run = ++run_](const LatestWork::IsWanted& isWanted) {
    stepBack();
    WorkClock::time_point told{};
    const Progress progress = [&](std::string_view what, int done, int total) {
      if (!isWanted()) return false;
      if (WorkClock::now() - told < kTellWorkEvery) return true;
      told = WorkClock::now();
      deliver(run, [this, text = qtext(what), done, total] { Q_EMIT progressed(text, done, total); });
      return true;
    };
    QString error;
    try {
      act([this, run](const std::function<void()>& found) { deliver(run, found); }, progress);
    } catch (const Cancelled&) { // what was found is told
    } catch (const std::exception& failure) {
      error = QString::fromStdString(shownReason(failure));
    }
    deliver(run, [this, error] { end(error); });
  });
}

void BackgroundWork::cancel() {
  if (!isRunning_) return;
  thread_.cancel();
  ++run_;
  end({});
}

void BackgroundWork::deliver(int run, const std::function<void()>& act) {
  QMetaObject::invokeMethod(
      this,
      [this, run, act] {
        if (run == run_) act();
      },
      Qt::QueuedConnection);
}

void BackgroundWork::end(const QString& error) {
  isRunning_ = false;
  Q_EMIT ended(error);
}

} // namespace taa::app
