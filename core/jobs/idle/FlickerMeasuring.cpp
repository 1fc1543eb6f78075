#include "core/jobs/idle/FlickerMeasuring.h"

#include "core/base/Error.h"
#include "core/base/Say.h"

namespace taa {

// The next one whose flicker is to be measured; nothing where it is known where somebody wants it.
std::optional<int> FlickerMeasuring::lane() const {
  if (!desk_.isOpen() || transport_.isPlaying() || stoppedAt_ == desk_.version()) return {};
  const int lanes = desk_.inspector.shot().laneCount();
  for (int lane = 0; lane < lanes; ++lane) {
    const int wanted = wanted_.flickerSamplesOf(lane);
    if (wanted < 0) continue;
    const std::optional<int> known = desk_.inspector.flicker().samples(lane);
    if (!known || (wanted > 0 && *known != wanted)) return lane;
  }
  return {};
}

void FlickerMeasuring::step() {
  const int lane = *this->lane();
  isTold_ = true;
  bool goesOn = false;
  const bool isDone = desk_.attempt(RequestKind::Reference, [&] {
    try {
      desk_.inspector.flicker().refine(
          wanted_.flickerSamplesOf(lane),
          desk_.progressUntilAny(WorkKind::Flicker, say<"Measuring the flicker">()), lane);
    } catch (const Cancelled&) {
      goesOn = true;
    }
  });
  if (!isDone) stoppedAt_ = desk_.version();
  if (isDone && !goesOn) ++desk_.referenceVersion;
  endIfDone();
}

void FlickerMeasuring::endIfDone() {
  if (isTold_ && !lane()) {
    isTold_ = false;
    desk_.endWork();
  }
}

} // namespace taa
