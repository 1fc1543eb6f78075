// The camera in somebody's hands: flown, recorded, put down.
#pragma once

#include "core/jobs/context/Transport.h"
#include "core/jobs/shot/SeekTarget.h"
#include "core/requests/Requests.h"
#include "core/scene/camera/FlightRecording.h"

#include <optional>
#include <vector>

namespace taa {

class CameraFlight {
 public:
  using Clock = FlightRecording::Clock;

  CameraFlight(JobContext& jobContext, Transport& transport, SeekTarget& seekTarget)
      : jobContext_(jobContext), transport_(transport), seekTarget_(seekTarget) {}

  // Poses and recordings that are taken up together are dealt with together, by settle().
  void take(const request::Fly& fly) { poses_.push_back(fly); }
  void take(const request::SetRecording& recording) { switches_.push_back(recording); }
  void take(const request::SetPlayback&);
  /// A recording has all poses that were flown while it went on, also where its beginning and its end are
  /// taken up together; what is on show has the last one.
  void settle();

  /// Somebody jumps, pauses or opens another scene: a recording is done, and a camera that was only flown
  /// rests where it is, in all frames.
  void end();

  bool isRecording() const { return recording_.has_value(); }
  /// Expects isRecording().
  const FlightRecording& recording() const { return *recording_; }
  /// Goes to the frame it ended at: how many of them could be shown meanwhile depends on the machine.
  void endRecording(Clock::time_point at);
  /// Gives frame `frame`, which comes next, the pose that was flown to.
  void layPose(int frame);

 private:
  void record();
  void beginRecording(Clock::time_point at);
  bool switchRecordings();
  void layTrack(int frame, const CameraPose& pose);
  CameraTrackHandle currentTrack() const;

  JobContext& jobContext_;
  Transport& transport_;
  SeekTarget& seekTarget_;
  std::vector<request::Fly> poses_;             // that wait for settle()
  std::vector<request::SetRecording> switches_; // the same
  std::optional<CameraPose> pose_;              // that the next frame is given
  bool isLaying_ = false; // frames after the one on show get poses: what was known of them is dropped
  std::optional<FlightRecording> recording_;
  CameraTrack recorded_; // what it adds to: its name, and what was flown before it
  bool playsAfter_ = false;
};

} // namespace taa
