#include "core/jobs/RenderThread.h"

#include "core/base/ShownText.h"
#include "core/gl/ContextLock.h"
#include "core/jobs/Scheduler.h"
#include "core/requests/RequestQueue.h"
#include "core/requests/WaitingRequests.h"

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <variant>

namespace taa {

struct RenderThread::Impl {
  Listener listener;
  ClockNow now;
  WaitingRequests waiting;
  std::mutex mutex; // guards what follows, for a moment only: a queue is moved under it, and nothing else
  std::condition_variable posted, answered;
  RequestQueue requests;
  RequestId last = 0, done = 0; // posted, and answered
  bool ends = false;
  std::thread thread;

  void run();
  void runScheduler();
  std::optional<RequestQueue> take(const Scheduler::Agenda& agenda);
};

// Waits until there is something to do; nothing: it ends.
std::optional<RequestQueue> RenderThread::Impl::take(const Scheduler::Agenda& agenda) {
  std::unique_lock lock(mutex);
  const auto hasNews = [this] { return ends || !requests.isEmpty(); };
  if (!hasNews() && !agenda.isAwaited) {
    done = last;
    answered.notify_all();
    if (!agenda.next && agenda.wakesAt)
      posted.wait_until(lock, *agenda.wakesAt, hasNews);
    else if (!agenda.next)
      posted.wait(lock, hasNews);
  }
  if (ends) return {};
  waiting.clear();
  return std::exchange(requests, {});
}

void RenderThread::Impl::run() {
  try {
    runScheduler();
  } catch (const std::exception& error) { // no GL
    if (listener) listener({0, Failure{.sentence = shownReason(error), .isEnd = true}});
    while (take({})) continue;
  }
}

void RenderThread::Impl::runScheduler() {
  gl::ContextLock lock;
  Scheduler scheduler(listener, waiting, now);
  scheduler.deliver();
  const auto takeNext = [&](const Scheduler::Agenda& agenda) {
    std::optional<RequestQueue> taken;
    lock.restDuring([&] { taken = take(agenda); });
    return taken;
  };
  for (Scheduler::Agenda agenda = scheduler.agenda(); auto taken = takeNext(agenda);
       agenda = scheduler.agenda()) {
    if (!taken->isEmpty())
      scheduler.takeUp(std::move(*taken));
    else if (agenda.next)
      agenda.next->step();
    scheduler.deliver();
  }
}

RenderThread::RenderThread(Listener listener, ClockNow now) : impl_(std::make_unique<Impl>()) {
  impl_->listener = std::move(listener);
  impl_->now = std::move(now);
  impl_->thread = std::thread([impl = impl_.get()] { impl->run(); });
}

RenderThread::~RenderThread() {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->ends = true;
    impl_->waiting.end();
  }
  impl_->posted.notify_one();
  impl_->thread.join();
}

RequestId RenderThread::post(Request request) {
  std::visit(
      [&](auto& asked) {
        if constexpr (requires { asked.at; }) asked.at = impl_->now();
      },
      request);
  RequestId id = 0;
  {
    const std::lock_guard lock(impl_->mutex);
    id = ++impl_->last;
    impl_->waiting.add(request);
    impl_->requests.post({id, std::move(request)});
  }
  impl_->posted.notify_one();
  return id;
}

void RenderThread::waitUntilIdle() {
  std::unique_lock lock(impl_->mutex);
  const RequestId upTo = impl_->last;
  impl_->answered.wait(lock, [&] { return impl_->done >= upTo; });
}

} // namespace taa
