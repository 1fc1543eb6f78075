#include "core/jobs/idle/Refinement.h"

#include "core/base/Error.h"

namespace taa {

std::optional<int> Refinement::lane() const {
  if (!jobContext_.isOpen() || transport_.isPlaying() || stoppedAt_ == jobContext_.version()) return {};
  const int lanes = jobContext_.inspector.shot().laneCount();
  for (int lane = 0; lane < lanes; ++lane)
    if (isWanted(lane)) return lane;
  return {};
}

void Refinement::step() {
  isTold_ = true;
  bool goesOn = false;
  const bool isDone = jobContext_.attempt(RequestKind::Reference, [&] {
    try {
      refine(*lane());
    } catch (const Cancelled&) {
      goesOn = true;
    }
  });
  if (!isDone) stop();
  if (isDone && !goesOn) ++jobContext_.referenceVersion;
  endIfDone();
}

// Nobody waits for it any more.
void Refinement::endIfDone() {
  if (!isTold_ || lane()) return;
  isTold_ = false;
  jobContext_.endWork();
}

} // namespace taa
