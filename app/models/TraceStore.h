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

  /// Null when nothing is known of the pin.
  const PixelTrace* traceOf(const ProbePin& pin) const;
  /// Those of `pins`, in their order; empty traces where nothing is known.
  std::vector<PinTrace> tracesOf(const std::vector<ProbePin>& pins) const;

 private:
  std::uint64_t shotVersion_ = 0;
  std::vector<PinTrace> traces_; ///< also of pins that were moved: they may come back
};

} // namespace taa::app
