#include "app/models/TraceStore.h"

#include <algorithm>
#include <cstdint>

namespace taa::app {

bool TraceStore::setShotVersion(std::uint64_t shotVersion) {
  if (shotVersion == shotVersion_) return false;
  shotVersion_ = shotVersion;
  traces_.clear();
  return true;
}

bool TraceStore::add(const TraceDelivery& delivery) {
  if (delivery.shotVersion < shotVersion_) return false;
  setShotVersion(delivery.shotVersion);
  auto found = std::ranges::find_if(
      traces_, [&](const PinTrace& known) { return isSamePlace(known.pin, delivery.pin); });
  if (found == traces_.end()) found = traces_.insert(traces_.end(), PinTrace{delivery.pin, {}});
  found->trace.add(delivery.frame, delivery.sample);
  return true;
}

const PixelTrace* TraceStore::traceOf(const ProbePin& pin) const {
  for (const PinTrace& known : traces_)
    if (isSamePlace(known.pin, pin)) return &known.trace;
  return nullptr;
}

std::vector<PinTrace> TraceStore::tracesOf(const std::vector<ProbePin>& pins) const {
  std::vector<PinTrace> traces;
  for (const ProbePin& pin : pins) {
    const PixelTrace* trace = traceOf(pin);
    traces.push_back({pin, trace ? *trace : PixelTrace()});
  }
  return traces;
}

} // namespace taa::app
