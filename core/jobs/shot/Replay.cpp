#include "core/jobs/shot/Replay.h"

#include "core/base/Error.h"
#include "core/base/Say.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <utility>

namespace taa {

void Replay::take(const request::Seek& seek) {
  if (!desk_.isOpen()) return;
  flight_.end();
  setGoal(std::clamp(seek.frame, 0, desk_.inspector.shot().frameCount() - 1));
}

void Replay::take(const request::Step& step) {
  if (!desk_.isOpen()) return;
  flight_.end(); // time is taken out of its hands
  transport_.setPlaying(false);
  const InspectedShot& shot = desk_.inspector.shot();
  const std::int64_t from = goal_.frame.value_or(shot.frame());
  setGoal(static_cast<int>(std::clamp<std::int64_t>(from + step.frames, 0, shot.frameCount() - 1)));
}

void Replay::take(const request::Cancel&) {
  goal_.frame.reset();
  desk_.isReplayStopped = desk_.isStatusOld = true;
}

void Replay::setGoal(int frame) {
  goal_.set(frame);
  desk_.isReplayStopped = false;
}

bool Replay::needsRefinement() const {
  return desk_.isOpen() && !transport_.isPlaying() && !desk_.isReplayStopped &&
         !desk_.inspector.shot().areAllExact();
}

void Replay::step() {
  if (!goal_.frame) {
    replay(desk_.inspector.shot().frame(), replayText(desk_.inexactSince()));
    return;
  }
  if (!goNear()) replay(*goal_.frame, say<"Going to frame %1">(*goal_.frame));
}

// Before a long way: shows the nearest cached frame when it is much nearer than what is on show, and tells
// that another one is on its way. Returns whether there is something to deliver.
bool Replay::goNear() {
  InspectedShot& shot = desk_.inspector.shot();
  if (std::exchange(goal_.isNear, true) || shot.replayLength(*goal_.frame) <= 1) return false;
  const int near = shot.nearestCached(*goal_.frame);
  desk_.isStatusOld = true;
  if (2 * std::abs(*goal_.frame - near) > std::abs(*goal_.frame - shot.frame())) return true;
  desk_.attempt(RequestKind::Time, [&] { shot.seek(near); });
  desk_.noteFrame();
  return true;
}

// As far as requests let it; what they interrupt is taken up again by the next step().
void Replay::replay(int frame, const std::string& what) {
  InspectedShot& shot = desk_.inspector.shot();
  const int oldFrame = shot.frame();
  const bool wasExact = shot.areAllExact();
  bool isCancelled = false;
  const bool isGoing = goal_.frame || desk_.inexactSince().empty();
  desk_.attempt(isGoing ? RequestKind::Time : desk_.inexactSince().back(), [&] {
    try {
      shot.seek(frame, desk_.progressOfReplay(WorkKind::Replay, what));
    } catch (const Cancelled&) {
      isCancelled = true;
    }
  });
  desk_.endWork();
  if (isCancelled) return;
  if (std::exchange(goal_.frame, {})) desk_.isStatusOld = true;
  if (!shot.areAllExact()) desk_.isReplayStopped = true; // it failed
  if (shot.frame() != oldFrame || shot.areAllExact() != wasExact) desk_.noteFrame();
}

} // namespace taa
