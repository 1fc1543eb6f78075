#include "core/jobs/idle/Refinement.h"

#include "core/base/Error.h"

namespace taa {

std::optional<int> Refinement::lane() const {
  if (!desk_.isOpen() || transport_.isPlaying() || stoppedAt_ == desk_.version()) return {};
  const int lanes = desk_.inspector.shot().laneCount();
  for (int lane = 0; lane < lanes; ++lane)
    if (isWanted(lane)) return lane;
  return {};
}

void Refinement::step() {
  isTold_ = true;
  bool goesOn = false;
  const bool isDone = desk_.attempt(RequestKind::Reference, [&] {
    try {
      refine(*lane());
    } catch (const Cancelled&) {
      goesOn = true;
    }
  });
  if (!isDone) stop();
  if (isDone && !goesOn) ++desk_.referenceVersion;
  endIfDone();
}

// Nobody waits for it any more.
void Refinement::endIfDone() {
  if (!isTold_ || lane()) return;
  isTold_ = false;
  desk_.endWork();
}

} // namespace taa
