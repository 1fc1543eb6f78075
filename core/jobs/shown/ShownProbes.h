// Delivers what is at the probes of each frame on show.
#pragma once

#include "core/jobs/context/JobContext.h"
#include "core/jobs/context/Subscriptions.h"
#include "core/jobs/idle/PixelJudging.h"
#include "core/jobs/idle/Traces.h"
#include "core/requests/Requests.h"

#include <cstdint>
#include <tuple>

namespace taa {

class ShownProbes {
 public:
  ShownProbes(JobContext& jobContext, Subscriptions& subscriptions, Traces& traces, PixelJudging& judging)
      : jobContext_(jobContext), subscriptions_(subscriptions), traces_(traces), judging_(judging) {}

  void take(const request::SetProbes& probes);
  void take(const request::SetTracing&) { delivered_ = {}; } // the frame on show is a part of it
  void deliver();

 private:
  void deliverProbe(int index);
  void addOther(ProbeResult& result, const OtherSide& other);
  ProbeResult resultOf(Probe& probe, bool isActive);

  JobContext& jobContext_;
  Subscriptions& subscriptions_;
  Traces& traces_;
  PixelJudging& judging_;
  // Versions of frame, reference and comparison frames
  std::tuple<std::uint64_t, std::uint64_t, std::uint64_t> delivered_;
};

} // namespace taa
