// One kind of work of the render thread, done piece by piece.
#pragma once

#include <chrono>
#include <optional>

namespace taa {

/// A job hears of the requests that concern it by members take(const request::…&), which the scheduler finds
/// by their types: request::Cancel is how it is cancelled. It tells of its work and ends that by itself.
class Job {
 public:
  using Clock = std::chrono::steady_clock;

  Job() = default;
  virtual ~Job() = default;
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  /// Whether step() would do something now.
  virtual bool isDue() = 0;
  /// A piece of it: whatever waits is answered after it, or it stops by itself for that.
  virtual void step() = 0;
  /// When it will be due without a request; nothing: never, or it is due already.
  virtual std::optional<Clock::time_point> wakesAt() { return {}; }
  /// Whether who waits until all is done waits for this.
  virtual bool isAwaited() const { return true; }
  /// Requests were taken up: what is of no use any more ends.
  virtual void settle() {}
};

} // namespace taa
