#include "core/jobs/idle/FollowingSamples.h"

#include "core/base/Say.h"

#include <cstddef>
#include <memory>
#include <utility>

namespace taa {

void FollowingSamples::take(const request::SetLineage& wanted) {
  frames_ = wanted.frames;
  followed_.reset();
}

// Whether its surface was looked up makes it no other probe.
std::optional<FollowingSamples::Followed> FollowingSamples::now() const {
  const int active = wanted_.probes.active;
  if (frames_ == 0 || active < 0) return {};
  Followed followed{wanted_.probes.all[static_cast<std::size_t>(active)], desk_.version()};
  followed.probe.anchor.reset();
  return followed;
}

bool FollowingSamples::isDue() {
  if (!desk_.isOpen() || transport_.isPlaying() || !desk_.inspector.shot().isExact()) return false;
  const std::optional<Followed> wanted = now();
  return wanted && wanted != followed_;
}

// Any request is answered between two frames; then it begins anew.
void FollowingSamples::step() {
  const std::optional<Followed> wanted = now();
  const bool isDone = desk_.attempt(RequestKind::Lineage, [this] { follow(); });
  if (isDone || !desk_.waiting().any()) followed_ = wanted;
  desk_.endWork();
}

// A probe may lie outside for a while, when the size changes.
void FollowingSamples::follow() {
  const Probe& probe = wanted_.probes.all[static_cast<std::size_t>(wanted_.probes.active)];
  Inspector& inspector = desk_.inspector;
  const InspectedShot& shot = inspector.shot();
  LineageDelivery delivery{probe, shot.frame(), {}, desk_.shotVersion()};
  const bool isInside = probe.pixel.x >= 0 && probe.pixel.y >= 0 && probe.pixel.x < shot.width() &&
                        probe.pixel.y < shot.height();
  if (isInside || probe.anchor) {
    const ProbeSpot spot = inspector.probes().spot(inspector.probes().anchored(probe));
    if (spot.state == ProbeState::Seen || spot.state == ProbeState::Hidden)
      delivery.lineage = std::make_shared<const Lineage>(
          inspector.lineage().of(delivery.frame, spot.pixel, 0, {.frames = frames_},
                                 desk_.progressUntilAny(WorkKind::Lineage, say<"Following samples">())));
  }
  desk_.tell(RequestKind::Lineage, std::move(delivery));
}

} // namespace taa
