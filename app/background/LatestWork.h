// A thread that does the last thing it was asked for: whatever was asked before is of no use any more.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace taa::app {

class LatestWork {
 public:
  /// Asked by work under way, often enough: false once something newer was asked for, or nothing.
  using IsWanted = std::function<bool()>;
  /// Expects that it does not throw.
  using Work = std::function<void(const IsWanted&)>;

  LatestWork() = default;
  /// Waits until what is under way has ended.
  ~LatestWork();
  LatestWork(const LatestWork&) = delete;
  LatestWork& operator=(const LatestWork&) = delete;

  /// Takes the place of what waits, and of what is under way as soon as that has noticed. Returns at once.
  void post(Work work);
  void cancel();

 private:
  void run();

  std::mutex mutex_; // held for a moment only
  std::condition_variable posted_;
  Work next_;
  std::atomic<int> version_{0}; ///< counts what was asked for
  bool ends_ = false;
  std::thread thread_; // begun with the first work
};

} // namespace taa::app
