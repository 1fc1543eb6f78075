#include "core/gl/ContextLock.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string_view>

namespace taa::gl {

namespace {

// Everybody draws a number, and is let in when it is called.
class Queue {
 public:
  void enter() {
    std::unique_lock lock(mutex_);
    const std::uint64_t number = drawn_++;
    left_.wait(lock, [&] { return called_ == number; });
  }

  void leave() {
    {
      const std::lock_guard lock(mutex_);
      ++called_;
    }
    left_.notify_all();
  }

  /// Of somebody inside.
  bool isAwaited() {
    const std::lock_guard lock(mutex_);
    return drawn_ > called_ + 1;
  }

 private:
  std::mutex mutex_; // held for a moment only
  std::condition_variable left_;
  std::uint64_t drawn_ = 0, called_ = 0;
};

Queue& queue() {
  static Queue queue;
  return queue;
}

void leaveQueue() {
  if (eglGetCurrentContext() != EGL_NO_CONTEXT) glFinish();
  queue().leave();
}

} // namespace

ContextLock::ContextLock() {
  queue().enter();
}

ContextLock::~ContextLock() {
  leaveQueue();
}

void ContextLock::restDuring(const std::function<void()>& wait) {
  leaveQueue();
  try {
    wait();
  } catch (...) {
    queue().enter();
    throw;
  }
  queue().enter();
}

void ContextLock::pass() {
  if (queue().isAwaited()) restDuring([] {});
}

Progress ContextLock::passing(const Progress& progress) {
  return [this, progress](std::string_view what, int done, int total) {
    pass();
    return !progress || progress(what, done, total);
  };
}

} // namespace taa::gl
