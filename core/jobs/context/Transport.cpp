#include "core/jobs/context/Transport.h"

#include <algorithm>

namespace taa {

void Transport::setPlaying(bool playing) {
  if (playing == isPlaying_) return;
  isPlaying_ = playing;
  nextFrameAt_ = Clock::now();
  jobContext_.isStatusOld = true;
  jobContext_.isReplayStopped = false;
}

void Transport::setPlayback(const Playback& playback) {
  playback_ = playback;
  nextFrameAt_ = std::min(nextFrameAt_, Clock::now()); // from slow to fast at once
  jobContext_.isStatusOld = true;
}

std::pair<int, int> Transport::frames() const {
  const int last = jobContext_.inspector.shot().frameCount() - 1;
  if (!playback_.range) return {0, last};
  const int first = std::clamp(playback_.range->first, 0, last);
  return {first, std::clamp(playback_.range->second, first, last)};
}

double Transport::framesPerSecond() const {
  const double rate = playback_.framesPerSecond > 0.0
                          ? playback_.framesPerSecond
                          : jobContext_.inspector.shot().scene().shot.framesPerSecond;
  return rate * std::clamp(playback_.speed, kSlowestPlayback, kFastestPlayback);
}

void Transport::takeTurn() {
  const auto period = std::chrono::duration<double>(1.0 / framesPerSecond());
  nextFrameAt_ += std::chrono::duration_cast<Clock::duration>(period);
}

void Transport::fallBehind() {
  nextFrameAt_ = std::max(nextFrameAt_, Clock::now());
}

} // namespace taa
