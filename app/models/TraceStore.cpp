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
      traces_, [&](const ProbeTrace& known) { return isSamePlace(known.probe, delivery.probe); });
  if (found == traces_.end()) found = traces_.insert(traces_.end(), ProbeTrace{delivery.probe, {}});
  found->trace.add(delivery.frame, delivery.sample);
  return true;
}

const PixelTrace* TraceStore::traceOf(const Probe& probe) const {
  for (const ProbeTrace& known : traces_)
    if (isSamePlace(known.probe, probe)) return &known.trace;
  return nullptr;
}

std::vector<ProbeTrace> TraceStore::tracesOf(const std::vector<Probe>& probes) const {
  std::vector<ProbeTrace> traces;
  for (const Probe& probe : probes) {
    const PixelTrace* trace = traceOf(probe);
    traces.push_back({probe, trace ? *trace : PixelTrace()});
  }
  return traces;
}

} // namespace taa::app
