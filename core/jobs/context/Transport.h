// Whether the shot plays, and how: what decks of tape call their transport.
#pragma once

#include "core/jobs/context/JobContext.h"
#include "core/requests/Playback.h"

#include <chrono>
#include <utility>

namespace taa {

class Transport {
 public:
  using Clock = std::chrono::steady_clock;

  explicit Transport(JobContext& jobContext) : jobContext_(jobContext) {}

  bool isPlaying() const { return isPlaying_; }
  void setPlaying(bool playing);
  bool isLooping() const { return isLooping_; }
  void setLooping(bool looping) { isLooping_ = looping; }
  const Playback& playback() const { return playback_; }
  void setPlayback(const Playback& playback);

  /// First and last frame that are played. A range that was meant for a longer shot ends with this one.
  std::pair<int, int> frames() const;
  /// Frames of the shot that go by in a second.
  double framesPerSecond() const;

  /// When the next frame is to be begun.
  Clock::time_point nextFrameAt() const { return nextFrameAt_; }
  /// The next frame's turn is over: the one after it comes a period later.
  void takeTurn();
  /// When frames take longer than their time, time slows down.
  void fallBehind();

 private:
  JobContext& jobContext_;
  bool isPlaying_ = false, isLooping_ = true;
  Playback playback_;
  Clock::time_point nextFrameAt_;
};

} // namespace taa
