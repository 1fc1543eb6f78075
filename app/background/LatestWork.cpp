#include "app/background/LatestWork.h"

#include <utility>

namespace taa::app {

LatestWork::~LatestWork() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
    ++version_;
  }
  posted_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void LatestWork::post(Work work) {
  {
    const std::lock_guard lock(mutex_);
    next_ = std::move(work);
    ++version_;
    if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
  }
  posted_.notify_one();
}

void LatestWork::cancel() {
  const std::lock_guard lock(mutex_);
  next_ = nullptr;
  ++version_;
}

void LatestWork::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    posted_.wait(lock, [this] { return ends_ || next_; });
    if (ends_) return;
    const Work work = std::exchange(next_, nullptr);
    const int version = version_;
    lock.unlock();
    work([this, version] { return version_ == version; });
    lock.lock();
  }
}

} // namespace taa::app
