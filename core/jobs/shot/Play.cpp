#include "core/jobs/shot/Play.h"

#include <utility>

namespace taa {

void Play::take(const request::SetPlaying& wanted) {
  if (!desk_.isOpen()) return;
  const auto [first, last] = transport_.frames();
  const bool restarts = wanted.playing && !transport_.isPlaying() && !transport_.isLooping() &&
                        desk_.inspector.shot().frame() == last;
  if (!wanted.playing) flight_.end();
  transport_.setPlaying(wanted.playing);
  if (restarts) goal_.frame = first;
  goal_.isNear = false;
}

// Frames outside the range lead into it. A recording goes by the clock, to its own end.
void Play::step() {
  if (flight_.isRecording() && flight_.recording().isFull(desk_.now())) {
    flight_.endRecording(desk_.now());
    return;
  }
  const bool isRecording = flight_.isRecording();
  const auto [first, last] =
      isRecording ? std::pair(0, flight_.recording().lastFrame()) : transport_.frames();
  const int now = desk_.inspector.shot().frame();
  transport_.takeTurn();
  if (now < last && now >= first) {
    advance(now);
    return;
  }
  if (!isRecording) startAgain(first, last); // else its clock is not there yet
}

void Play::startAgain(int first, int last) {
  flight_.end();
  InspectedShot& shot = desk_.inspector.shot();
  const int now = shot.frame();
  if ((first == last && now == first) || (now >= last && !transport_.isLooping())) {
    transport_.setPlaying(false);
    return;
  }
  if (shot.replayLength(first) > 1) { // a long way, which requests may end
    goal_.frame = first;
    goal_.isNear = true; // what is on show stays until then
    return;
  }
  if (!desk_.attempt(RequestKind::Time, [&] { shot.seek(first); })) transport_.setPlaying(false);
  transport_.fallBehind();
  desk_.noteFrame();
}

void Play::advance(int from) {
  const bool isDone = desk_.attempt(RequestKind::Time, [&] {
    flight_.layPose(from + 1);
    desk_.inspector.shot().advance();
  });
  if (!isDone) {
    flight_.end();
    transport_.setPlaying(false);
  }
  transport_.fallBehind();
  desk_.noteFrame();
}

} // namespace taa
