// Delivers what is at the probes of each frame on show.
#pragma once

#include "core/jobs/desk/Desk.h"
#include "core/jobs/desk/Wanted.h"
#include "core/jobs/idle/PixelJudging.h"
#include "core/jobs/idle/Traces.h"
#include "core/requests/Requests.h"

#include <cstdint>
#include <tuple>

namespace taa {

class ShownProbes {
 public:
  ShownProbes(Desk& desk, Wanted& wanted, Traces& traces, PixelJudging& judging)
      : desk_(desk), wanted_(wanted), traces_(traces), judging_(judging) {}

  void take(const request::SetProbes& probes);
  void take(const request::SetTracing&) { delivered_ = {}; } // the frame on show is a part of it
  void deliver();

 private:
  void deliverProbe(int index);
  void addOther(ProbeResult& result, const OtherSide& other);
  ProbeResult resultOf(Probe& probe, bool isActive);

  Desk& desk_;
  Wanted& wanted_;
  Traces& traces_;
  PixelJudging& judging_;
  // Versions of frame, reference and comparison frames
  std::tuple<std::uint64_t, std::uint64_t, std::uint64_t> delivered_;
};

} // namespace taa
