#include "core/jobs/shot/Replay.h"

#include "core/base/Error.h"
#include "core/base/Say.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <utility>

namespace taa {

void Replay::take(const request::Seek& seek) {
  if (!jobContext_.isOpen()) return;
  flight_.end();
  setGoal(std::clamp(seek.frame, 0, jobContext_.inspector.shot().frameCount() - 1));
}

void Replay::take(const request::Step& step) {
  if (!jobContext_.isOpen()) return;
  flight_.end(); // time is taken out of its hands
  transport_.setPlaying(false);
  const InspectedShot& shot = jobContext_.inspector.shot();
  const std::int64_t from = seekTarget_.frame.value_or(shot.frame());
  setGoal(static_cast<int>(std::clamp<std::int64_t>(from + step.frames, 0, shot.frameCount() - 1)));
}

void Replay::take(const request::Cancel&) {
  seekTarget_.frame.reset();
  jobContext_.isReplayStopped = jobContext_.isStatusOld = true;
}

void Replay::setGoal(int frame) {
  seekTarget_.set(frame);
  jobContext_.isReplayStopped = false;
}

bool Replay::needsRefinement() const {
  return jobContext_.isOpen() && !transport_.isPlaying() && !jobContext_.isReplayStopped &&
         !jobContext_.inspector.shot().areAllExact();
}

void Replay::step() {
  if (!seekTarget_.frame) {
    replay(jobContext_.inspector.shot().frame(), replayText(jobContext_.inexactSince()));
    return;
  }
  if (!goNear()) replay(*seekTarget_.frame, say<"Going to frame %1">(*seekTarget_.frame));
}

// Before a long way: shows the nearest cached frame when it is much nearer than what is on show, and tells
// that another one is on its way. Returns whether there is something to deliver.
bool Replay::goNear() {
  InspectedShot& shot = jobContext_.inspector.shot();
  if (std::exchange(seekTarget_.isNear, true) || shot.replayLength(*seekTarget_.frame) <= 1) return false;
  const int near = shot.nearestCached(*seekTarget_.frame);
  jobContext_.isStatusOld = true;
  if (2 * std::abs(*seekTarget_.frame - near) > std::abs(*seekTarget_.frame - shot.frame())) return true;
  jobContext_.attempt(RequestKind::Time, [&] { shot.seek(near); });
  jobContext_.noteFrame();
  return true;
}

// As far as requests let it; what they interrupt is taken up again by the next step().
void Replay::replay(int frame, const std::string& what) {
  InspectedShot& shot = jobContext_.inspector.shot();
  const int oldFrame = shot.frame();
  const bool wasExact = shot.areAllExact();
  bool isCancelled = false;
  const bool isGoing = seekTarget_.frame || jobContext_.inexactSince().empty();
  jobContext_.attempt(isGoing ? RequestKind::Time : jobContext_.inexactSince().back(), [&] {
    try {
      shot.seek(frame, jobContext_.progressOfReplay(WorkKind::Replay, what));
    } catch (const Cancelled&) {
      isCancelled = true;
    }
  });
  jobContext_.endWork();
  if (isCancelled) return;
  if (std::exchange(seekTarget_.frame, {})) jobContext_.isStatusOld = true;
  if (!shot.areAllExact()) jobContext_.isReplayStopped = true; // it failed
  if (shot.frame() != oldFrame || shot.areAllExact() != wasExact) jobContext_.noteFrame();
}

} // namespace taa
