// What is at the probes over frames: every exact frame on show adds to it; the others are filled in on
// demand, beside what is shown.
#pragma once

#include "core/jobs/desk/Job.h"
#include "core/jobs/desk/Transport.h"
#include "core/jobs/desk/Wanted.h"
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
  Traces(Desk& desk, const Transport& transport, Wanted& wanted)
      : desk_(desk), transport_(transport), wanted_(wanted) {}

  void take(const request::SetTracing& wanted);
  void take(const request::FillTraces& wanted) { filling_ = {wanted.first, wanted.last}; }
  void take(const request::TraceInIdleTime& wanted);
  void take(const request::Cancel&);
  void settle() override;

  bool isDue() override {
    return filling_ && desk_.isOpen() && !transport_.isPlaying() && !wanted_.probes.all.empty();
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

  Desk& desk_;
  const Transport& transport_;
  Wanted& wanted_;
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
