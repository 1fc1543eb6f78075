// What is at the probes over frames: every exact frame on show adds to it; the others are filled in on
// demand, beside what is shown.
#pragma once

#include "core/jobs/context/Job.h"
#include "core/jobs/context/Subscriptions.h"
#include "core/jobs/context/Transport.h"
#include "core/probe/PixelTrace.h"
#include "core/replay/TraceCursor.h"
#include "core/requests/Requests.h"

#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace taa {

class Traces final : public Job {
 public:
  Traces(JobContext& jobContext, const Transport& transport, Subscriptions& subscriptions)
      : jobContext_(jobContext), transport_(transport), subscriptions_(subscriptions) {}

  void take(const request::SetTracing& subscriptions);
  void take(const request::FillTraces& subscriptions) {
    filling_ = {subscriptions.first, subscriptions.last};
  }
  void take(const request::TraceInIdleTime& subscriptions);
  void take(const request::Cancel&);
  void settle() override;

  bool isDue() override {
    return filling_ && jobContext_.isOpen() && !transport_.isPlaying() && !subscriptions_.probes.all.empty();
  }
  void step() override;

  /// Whether a frame is missing of those that are wanted in idle time; and one of them is made.
  bool isMissingOne();
  void makeOne();

  /// A probe of the frame on show has seen it anyway.
  void noteShown(const ProbeResult& result);

 private:
  void end();
  void fill();
  void trace(int frame);
  std::vector<Probe> missingAt(int frame);
  std::optional<int> firstMissing();
  std::set<int>& framesOf(const Probe& probe);
  void deliver(const Probe& probe, int frame, const std::optional<TraceSample>& sample);

  JobContext& jobContext_;
  const Transport& transport_;
  Subscriptions& subscriptions_;
  bool isWanted_ = false;
  std::uint64_t shotVersion_ = 0;                      // what follows is of this one
  std::vector<std::pair<Probe, std::set<int>>> known_; // frames
  std::optional<std::pair<int, int>> filling_;         // first and last frame
  std::optional<std::pair<int, int>> inIdleTime_;      // likewise
  int firstUnsure_ = 0;                                // all before it are known
  TraceCursor cursor_;
};

/// The same without being asked, after everything else.
class TracesInIdleTime final : public Job {
 public:
  explicit TracesInIdleTime(Traces& traces) : traces_(traces) {}
  bool isDue() override { return traces_.isMissingOne(); }
  void step() override { traces_.makeOne(); }
  bool isAwaited() const override { return false; }

 private:
  Traces& traces_;
};

} // namespace taa
