// How the render thread lets time go on while it plays.
#include "core/RenderWorker.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace taa {

void RenderWorker::applyPlayback(const Wishes& wishes) {
  if (wishes.looping) looping_ = *wishes.looping;
  if (!wishes.playback) return;
  playback_ = *wishes.playback;
  nextFrameAt_ = std::min(nextFrameAt_, Clock::now()); // from slow to fast at once
  statusChanged_ = true;
}

// First and last; a range that was meant for a longer shot ends with this one.
std::pair<int, int> RenderWorker::playedFrames() const {
  const int last = inspector_.frameCount() - 1;
  if (!playback_.range) return {0, last};
  const int first = std::clamp(playback_.range->first, 0, last);
  return {first, std::clamp(playback_.range->second, first, last)};
}

void RenderWorker::setPlaying(bool playing) {
  if (playing == playing_) return;
  playing_ = playing;
  nextFrameAt_ = Clock::now();
  statusChanged_ = true;
  refinementStopped_ = false;
}

// The next frame, in its turn: when frames take longer than their time, time slows down. Frames outside the
// range lead into it.
void RenderWorker::playOn() {
  const auto [first, last] = playedFrames();
  const int now = inspector_.frame();
  const bool wraps = now >= last || now < first;
  if (wraps) endFlight();
  if (wraps && ((first == last && now == first) || (now >= last && !looping_))) return setPlaying(false);
  const double rate =
      playback_.framesPerSecond > 0.0 ? playback_.framesPerSecond : inspector_.scene().shot.framesPerSecond;
  const double speed = std::clamp(playback_.speed, kSlowestPlayback, kFastestPlayback);
  nextFrameAt_ +=
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1.0 / (rate * speed)));
  if (wraps && inspector_.replayLength(first) > 1) { // a long way, which wishes may end
    goal_ = first;
    isNear_ = true; // what is on show stays until then
    return;
  }
  const bool done = attempt([&] {
    if (wraps) return inspector_.seek(first);
    if (flight_.pose) layTrack(now + 1, *flight_.pose);
    flight_.pose.reset();
    inspector_.advance();
  });
  if (!done) setPlaying(false);
  nextFrameAt_ = std::max(nextFrameAt_, Clock::now());
  ++version_;
  statusChanged_ = true;
}

} // namespace taa
