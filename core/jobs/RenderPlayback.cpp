// How the render thread lets time go on while it plays.
#include "core/jobs/RenderWorker.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace taa {

void RenderWorker::applyPlayback(const Wishes& wishes) {
  if (wishes.looping) looping_ = *wishes.looping;
  if (!wishes.playback) return;
  playback_ = *wishes.playback;
  if (flight_.recording) flight_.recording->setRate(playedPerSecond(), now_());
  nextFrameAt_ = std::min(nextFrameAt_, Clock::now()); // from slow to fast at once
  statusChanged_ = true;
}

// First and last; a range that was meant for a longer shot ends with this one.
std::pair<int, int> RenderWorker::playedFrames() const {
  const int last = inspector_.shot().frameCount() - 1;
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

double RenderWorker::playedPerSecond() const {
  const double rate = playback_.framesPerSecond > 0.0 ? playback_.framesPerSecond
                                                      : inspector_.shot().scene().shot.framesPerSecond;
  return rate * std::clamp(playback_.speed, kSlowestPlayback, kFastestPlayback);
}

// The next frame, in its turn: when frames take longer than their time, time slows down. Frames outside the
// range lead into it. A recording goes by the clock, to its own end.
void RenderWorker::playOn() {
  const bool isRecording = flight_.recording.has_value();
  if (isRecording && flight_.recording->isFull(now_())) return endRecording(now_());
  const auto [first, last] = isRecording ? std::pair(0, flight_.recording->lastFrame()) : playedFrames();
  const int now = inspector_.shot().frame();
  const bool wraps = now >= last || now < first;
  const auto period = std::chrono::duration<double>(1.0 / playedPerSecond());
  nextFrameAt_ += std::chrono::duration_cast<Clock::duration>(period);
  if (wraps && isRecording) return; // its clock is not there yet
  if (wraps) endFlight();
  if (wraps && ((first == last && now == first) || (now >= last && !looping_))) return setPlaying(false);
  if (wraps && inspector_.shot().replayLength(first) > 1) { // a long way, which wishes may end
    goal_ = first;
    isNear_ = true; // what is on show stays until then
    return;
  }
  const bool done = attempt(RequestKind::Time, [&] {
    if (wraps) return inspector_.shot().seek(first);
    if (flight_.pose) layTrack(now + 1, *flight_.pose);
    flight_.pose.reset();
    inspector_.shot().advance();
  });
  if (!done) {
    endFlight();
    setPlaying(false);
  }
  nextFrameAt_ = std::max(nextFrameAt_, Clock::now());
  ++version_;
  statusChanged_ = true;
}

} // namespace taa
