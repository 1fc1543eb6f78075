// What was seen of the probes over frames, as long as it is true.
#pragma once

#include "core/requests/Results.h"

#include <cstdint>
#include <vector>

namespace taa::app {

class TraceStore {
 public:
  /// Drops all that is known when frames are a function of something else now (Status::shotVersion); true: so
  /// it was.
  bool setShotVersion(std::uint64_t shotVersion);
  /// False: it came too late.
  bool add(const TraceDelivery& delivery);

  /// Null when nothing is known of the probe.
  const PixelTrace* traceOf(const Probe& probe) const;
  /// Those of `probes`, in their order; empty traces where nothing is known.
  std::vector<ProbeTrace> tracesOf(const std::vector<Probe>& probes) const;

 private:
  std::uint64_t shotVersion_ = 0;
  std::vector<ProbeTrace> traces_; ///< also of probes that were moved: they may come back
};

} // namespace taa::app
