// What the jobs of the render thread share: the inspector, what is known of the frame on show, whom answers
// go to.
#pragma once

#include "core/base/Progress.h"
#include "core/inspect/Inspector.h"
#include "core/requests/Results.h"
#include "core/requests/WaitingRequests.h"
#include "core/scene/camera/FlightRecording.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace taa {

/// Lives on the render thread. Versions are those of the frame on show: they change with everything that it
/// depends on.
class JobContext {
 public:
  using Clock = FlightRecording::Clock;
  using ClockNow = std::function<Clock::time_point()>;

  /// `now` is the clock of whoever flies the camera. Throws Error when there is no GL.
  JobContext(const Listener& listener, const WaitingRequests& waiting, ClockNow now);

  Inspector inspector;

  bool isOpen() const { return !inspector.shot().source().empty(); }
  Clock::time_point now() const { return now_(); }

  // The frame on show
  std::uint64_t version() const { return version_; }
  std::uint64_t shotVersion() const { return shotVersion_; } ///< see Status
  /// Another frame, or the same one nearer to what it is to be.
  void noteFrame();
  /// Something that all frames depend on is another: what was delivered is of another version of the shot
  /// now.
  void noteChange(RequestKind kind);
  /// What is known of frames that are not on show is no longer true.
  void noteShotChange() { ++shotVersion_; }
  /// Kinds of requests since which the frame on show is not exact.
  const std::vector<RequestKind>& inexactSince() const { return inexactSince_; }
  void noteExact() { inexactSince_.clear(); }
  /// Replaying was cancelled or failed: not again until something changes.
  bool isReplayStopped = false;
  /// Something that the status says has changed.
  bool isStatusOld = true;
  // These change with the comparison frames, and with each picture of a reference or of flicker
  std::uint64_t comparisonVersion = 1, referenceVersion = 1;
  /// Changes when previews are on show of settings that do not come.
  std::uint64_t previewVersion = 1;

  // Requests
  const WaitingRequests& waiting() const { return waiting_; }
  void noteTaken(RequestKind kind, RequestId id) { latest_.note(kind, id); }
  RequestId latest(RequestKind kind) const { return latest_.of(kind); }
  const LatestRequests& taken() const { return latest_; }

  // Answers
  void tell(RequestKind kind, Result result) const;
  void tellWork(WorkKind kind, std::string what, int done, int total) const;
  void endWork() const { tell(RequestKind::None, Work{}); }
  /// Reports `what` and stops as soon as anything waits.
  Progress progressUntilAny(WorkKind kind, std::string what) const;
  /// Reports it, and stops for what ends a replay: at once, or, for what a replay only pauses for, after the
  /// first step, so that it comes on however fast requests arrive: what was replayed until then is kept, and
  /// the replay goes on.
  Progress progressOfReplay(WorkKind kind, std::string what) const;
  /// Does it; an error is told, as an answer to the latest request of that kind, and changes nothing. Returns
  /// whether it was done. Whoever asked for something that failed shows what it asked for: the status says
  /// what is in force.
  bool attempt(RequestKind kind, const std::function<void()>& action);
  /// The same, of something that all frames depend on.
  bool change(RequestKind kind, const std::function<void()>& action);

 private:
  const Listener& listener_;
  const WaitingRequests& waiting_;
  ClockNow now_;
  LatestRequests latest_; // that were taken up
  std::vector<RequestKind> inexactSince_;
  std::uint64_t version_ = 1, shotVersion_ = 0;
};

} // namespace taa
