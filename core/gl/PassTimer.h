// Measures what each pass takes while it lives; without one, passes cost nothing but the question for it.
#pragma once

#include "core/gl/Context.h"

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

namespace taa::gl {

/// How passes are timed. Queries: the GPU's own clock before and after. Finish: the wall clock between two
/// glFinish, for drivers that run passes later than their queries (llvmpipe) and so time nothing.
enum class TimingMethod { Queries, Finish };
TimingMethod timingMethodFor(const Driver& driver);

struct PassTime {
  std::string pass;  ///< label of its RenderPass
  std::string group; ///< of the innermost PassGroup around it; empty: none
  double milliseconds = 0.0;
};

/// Times every RenderPass of its thread from now on; the latest made does, until it is destroyed. Needs the
/// current context for its whole life.
class PassTimer {
 public:
  explicit PassTimer(TimingMethod method);
  ~PassTimer();
  PassTimer(const PassTimer&) = delete;
  PassTimer& operator=(const PassTimer&) = delete;

  /// Whether one is there on this thread.
  static bool isTiming() { return current_ != nullptr; }

  TimingMethod method() const { return method_; }
  int framesStarted() const { return frames_; }
  /// The passes since the last call, in their order; waits for the GPU to have done them.
  std::vector<PassTime> take();

  /// Forgets what this thread's timer has measured so far: a new frame begins.
  static void startFrame();
  /// What RenderPass calls. All three do nothing without a timer on this thread.
  static void begin(const std::string& pass);
  static void end();

 private:
  friend class PassGroup;
  using Clock = std::chrono::steady_clock;
  struct Sample {
    PassTime time;
    unsigned first = 0, last = 0; // queries
  };
  unsigned query();
  void recycle();

  static thread_local PassTimer* current_;
  PassTimer* outer_;
  TimingMethod method_;
  std::vector<Sample> samples_;
  std::vector<unsigned> free_; // queries to use again
  std::string_view group_;
  int frames_ = 0;
  Clock::time_point start_;
};

/// Names the passes that begin while it lives. `name` must outlive it.
class PassGroup {
 public:
  explicit PassGroup(std::string_view name);
  ~PassGroup();
  PassGroup(const PassGroup&) = delete;
  PassGroup& operator=(const PassGroup&) = delete;

 private:
  PassTimer* timer_;
  std::string_view outer_;
};

} // namespace taa::gl
