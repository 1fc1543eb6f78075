#include "core/jobs/shown/ShownProbes.h"

#include "core/inspect/ShownPicture.h"

#include <cstddef>
#include <memory>
#include <tuple>
#include <utility>

namespace taa {

// What was found out about a probe holds as long as it is the same probe.
void ShownProbes::take(const request::SetProbes& probes) {
  request::SetProbes next = probes;
  for (Probe& probe : next.all) {
    if (probe.anchor) continue;
    Probe known = probe;
    for (const Probe& old : subscriptions_.probes.all) {
      known.anchor = old.anchor;
      if (known == old) probe.anchor = old.anchor;
    }
  }
  subscriptions_.probes = std::move(next);
  delivered_ = {};
}

void ShownProbes::deliver() {
  const std::tuple now(jobContext_.version(), jobContext_.referenceVersion,
                       subscriptions_.probes.other ? jobContext_.comparisonVersion : 0);
  if (delivered_ == now) return;
  delivered_ = now; // also when it fails: once is enough to tell
  for (int probe = 0; probe < static_cast<int>(subscriptions_.probes.all.size()); ++probe)
    deliverProbe(probe);
}

void ShownProbes::deliverProbe(int index) {
  Probe& probe = subscriptions_.probes.all[static_cast<std::size_t>(index)];
  const InspectedShot& shot = jobContext_.inspector.shot();
  // A probe may lie outside for a while, when the size changes.
  const bool isInside = probe.pixel.x >= 0 && probe.pixel.y >= 0 && probe.pixel.x < shot.width() &&
                        probe.pixel.y < shot.height();
  if (!isInside && !probe.anchor) return;
  jobContext_.attempt(RequestKind::Probes, [&] {
    const bool isActive = index == subscriptions_.probes.active;
    ProbeResult result = resultOf(probe, isActive);
    traces_.noteShown(result);
    if (isActive) judging_.noteShown(result);
    jobContext_.tell(RequestKind::Probes, std::move(result));
  });
}

// Nothing while it is on its way.
void ShownProbes::addOther(ProbeResult& result, const OtherSide& other) {
  const InspectedShot& shot = jobContext_.inspector.shot();
  PictureSource source = otherSource(other, shot.frame(), shot.frameCount());
  source.id = IntermediateId::resolved; // a row that needs no reference: all are given
  if (jobContext_.inspector.views().isCached(source))
    result.compared = jobContext_.inspector.probes().compared({result.x, result.y}, source);
}

ProbeResult ShownProbes::resultOf(Probe& probe, bool isActive) {
  const InspectedShot& shot = jobContext_.inspector.shot();
  Probes& probes = jobContext_.inspector.probes();
  probe = probes.anchored(probe);
  ProbeResult result{.probe = probe, .spot = probes.spot(probe), .around = {}};
  result.x = result.spot.pixel.x;
  result.y = result.spot.pixel.y;
  result.frame = shot.frame();
  if (result.spot.state == ProbeState::Seen || result.spot.state == ProbeState::Hidden) {
    result.around = probes.probeAround(result.x, result.y, 1);
    if (isActive) result.details = std::make_shared<const twin::Details>(probes.details(result.x, result.y));
    if (isActive && subscriptions_.probes.whatIf) {
      result.whatIf = probes.whatIf(result.x, result.y);
      result.sensitivities = probes.sensitivities(result.x, result.y);
    }
    if (isActive && subscriptions_.probes.other) addOther(result, *subscriptions_.probes.other);
  }
  result.exact = shot.isExact();
  result.settings = shot.usedSettings();
  result.info = shot.info();
  return result;
}

} // namespace taa
