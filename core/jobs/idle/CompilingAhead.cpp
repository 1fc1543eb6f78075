#include "core/jobs/idle/CompilingAhead.h"

#include "core/base/Error.h"

#include <chrono>
#include <utility>

namespace taa {

void CompilingAhead::take(const request::Prepare& subscriptions) {
  if (!jobContext_.isOpen()) return;
  prepared_ = subscriptions.settings;
  jobContext_.inspector.shot().prepareInBackground(*prepared_);
}

// Once it was compiled beside the frames it is taken over, which takes no longer than a frame; where nothing
// is kept on disk it is compiled here. Neither holds up a play. Errors are told to whoever makes the choice.
void CompilingAhead::step() {
  constexpr std::chrono::milliseconds kSlice{5}; // that a request may have to wait
  InspectedShot& shot = jobContext_.inspector.shot();
  if (!shot.waitUntilPrepared(kSlice)) return;
  try {
    shot.prepare(*std::exchange(prepared_, {}));
  } catch (const Error&) {
  }
}

} // namespace taa
