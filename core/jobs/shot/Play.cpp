#include "core/jobs/shot/Play.h"

#include <utility>

namespace taa {

void Play::take(const request::SetPlaying& subscriptions) {
  if (!jobContext_.isOpen()) return;
  const auto [first, last] = transport_.frames();
  const bool restarts = subscriptions.playing && !transport_.isPlaying() && !transport_.isLooping() &&
                        jobContext_.inspector.shot().frame() == last;
  if (!subscriptions.playing) flight_.end();
  transport_.setPlaying(subscriptions.playing);
  if (restarts) seekTarget_.frame = first;
  seekTarget_.isNear = false;
}

// Frames outside the range lead into it. A recording goes by the clock, to its own end.
void Play::step() {
  if (flight_.isRecording() && flight_.recording().isFull(jobContext_.now())) {
    flight_.endRecording(jobContext_.now());
    return;
  }
  const bool isRecording = flight_.isRecording();
  const auto [first, last] =
      isRecording ? std::pair(0, flight_.recording().lastFrame()) : transport_.frames();
  const int now = jobContext_.inspector.shot().frame();
  transport_.takeTurn();
  if (now < last && now >= first) {
    advance(now);
    return;
  }
  if (!isRecording) startAgain(first, last); // else its clock is not there yet
}

void Play::startAgain(int first, int last) {
  flight_.end();
  InspectedShot& shot = jobContext_.inspector.shot();
  const int now = shot.frame();
  if ((first == last && now == first) || (now >= last && !transport_.isLooping())) {
    transport_.setPlaying(false);
    return;
  }
  if (shot.replayLength(first) > 1) { // a long way, which requests may end
    seekTarget_.frame = first;
    seekTarget_.isNear = true; // what is on show stays until then
    return;
  }
  if (!jobContext_.attempt(RequestKind::Time, [&] { shot.seek(first); })) transport_.setPlaying(false);
  transport_.fallBehind();
  jobContext_.noteFrame();
}

void Play::advance(int from) {
  const bool isDone = jobContext_.attempt(RequestKind::Time, [&] {
    flight_.layPose(from + 1);
    jobContext_.inspector.shot().advance();
  });
  if (!isDone) {
    flight_.end();
    transport_.setPlaying(false);
  }
  transport_.fallBehind();
  jobContext_.noteFrame();
}

} // namespace taa
