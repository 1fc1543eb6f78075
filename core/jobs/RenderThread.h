// The Inspector on a thread of its own: requests in, answers out; std only. The caller never waits for GL.
#pragma once

#include "core/requests/Requests.h"
#include "core/requests/Results.h"

#include <functional>
#include <memory>

namespace taa {

/// Every member returns at once and may be called from any one thread. Requests coalesce as their types say,
/// and long work that a newer one makes useless is cancelled. Errors come as a Failure, say what they answer
/// and change nothing.
class RenderThread {
 public:
  using Clock = FlightRecording::Clock;
  using ClockNow = std::function<Clock::time_point()>; ///< called from any thread
  /// `now` is the clock of whoever flies the camera.
  explicit RenderThread(Listener listener, ClockNow now = Clock::now);
  /// Cancels what is under way and joins.
  ~RenderThread();
  RenderThread(const RenderThread&) = delete;
  RenderThread& operator=(const RenderThread&) = delete;

  RequestId post(Request request);
  /// Waits until all requests so far are answered; for tests and screenshots only.
  void waitUntilIdle();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace taa
