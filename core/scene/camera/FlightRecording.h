// The way of a camera that is flown, by the clock: a pose for each frame of the shot, whatever a machine
// shows of them meanwhile.
#pragma once

#include "core/scene/camera/CameraTrack.h"

#include <chrono>
#include <vector>

namespace taa {

/// Between moves the camera rests; within one it goes evenly. Times are those of whoever flies, rising.
class FlightRecording {
 public:
  using Clock = std::chrono::steady_clock;

  /// Begins at `firstFrame` with `pose` and ends at `lastFrame`.
  FlightRecording(int firstFrame, int lastFrame, const CameraPose& pose, Clock::time_point begins);

  int firstFrame() const { return firstFrame_; }
  int lastFrame() const { return lastFrame_; }
  /// Frames of the shot that go by in a second from `now` on; 0 until it is set.
  void setRate(double framesPerSecond, Clock::time_point now);
  /// The camera is at `pose`, after it moved for `took`.
  void moveTo(const CameraPose& pose, Clock::time_point now, Clock::duration took);

  /// Poses of all frames from the first one until `now`: the last one is where the camera is.
  std::vector<CameraPose> poses(Clock::time_point now) const;
  int frameCount(Clock::time_point now) const; ///< of them
  /// The last frame has been reached.
  bool isFull(Clock::time_point now) const;

 private:
  /// A move, in frames after the first one.
  struct Move {
    double from = 0.0, to = 0.0;
    CameraPose pose;
  };
  double position(Clock::time_point time) const;
  CameraPose poseAt(double position) const;

  int firstFrame_, lastFrame_;
  std::vector<Move> moves_;
  double positionSince_ = 0.0, framesPerSecond_ = 0.0;
  Clock::time_point since_;
};

} // namespace taa
