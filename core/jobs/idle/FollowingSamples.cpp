#include "core/jobs/idle/FollowingSamples.h"

#include "core/base/Say.h"

#include <cstddef>
#include <memory>
#include <utility>

namespace taa {

void FollowingSamples::take(const request::SetLineage& subscriptions) {
  frames_ = subscriptions.frames;
  followed_.reset();
}

// Whether its surface was looked up makes it no other probe.
std::optional<FollowingSamples::Followed> FollowingSamples::now() const {
  const int active = subscriptions_.probes.active;
  if (frames_ == 0 || active < 0) return {};
  Followed followed{subscriptions_.probes.all[static_cast<std::size_t>(active)], jobContext_.version()};
  followed.probe.anchor.reset();
  return followed;
}

bool FollowingSamples::isDue() {
  if (!jobContext_.isOpen() || transport_.isPlaying() || !jobContext_.inspector.shot().isExact())
    return false;
  const std::optional<Followed> subscriptions = now();
  return subscriptions && subscriptions != followed_;
}

// Any request is answered between two frames; then it begins anew.
void FollowingSamples::step() {
  const std::optional<Followed> subscriptions = now();
  const bool isDone = jobContext_.attempt(RequestKind::Lineage, [this] { follow(); });
  if (isDone || !jobContext_.waiting().any()) followed_ = subscriptions;
  jobContext_.endWork();
}

// A probe may lie outside for a while, when the size changes.
void FollowingSamples::follow() {
  const Probe& probe = subscriptions_.probes.all[static_cast<std::size_t>(subscriptions_.probes.active)];
  Inspector& inspector = jobContext_.inspector;
  const InspectedShot& shot = inspector.shot();
  LineageDelivery delivery{probe, shot.frame(), {}, jobContext_.shotVersion()};
  const bool isInside = probe.pixel.x >= 0 && probe.pixel.y >= 0 && probe.pixel.x < shot.width() &&
                        probe.pixel.y < shot.height();
  if (isInside || probe.anchor) {
    const ProbeSpot spot = inspector.probes().spot(inspector.probes().anchored(probe));
    if (spot.state == ProbeState::Seen || spot.state == ProbeState::Hidden)
      delivery.lineage = std::make_shared<const Lineage>(inspector.lineage().of(
          delivery.frame, spot.pixel, 0, {.frames = frames_},
          jobContext_.progressUntilAny(WorkKind::Lineage, say<"Following samples">())));
  }
  jobContext_.tell(RequestKind::Lineage, std::move(delivery));
}

} // namespace taa
