#include "core/jobs/shot/CameraFlight.h"

#include "core/base/Error.h"
#include "core/base/Say.h"

#include <algorithm>
#include <string>
#include <utility>

namespace taa {

namespace {

/// "Recorded 1", or the first number that is free.
std::string freeName(const std::vector<std::string>& cameras) {
  for (int number = 1;; ++number)
    if (std::string name = "Recorded " + std::to_string(number); std::ranges::count(cameras, name) == 0)
      return name;
}

} // namespace

void CameraFlight::take(const request::SetPlayback&) {
  if (recording_) recording_->setRate(transport_.framesPerSecond(), jobContext_.now());
}

void CameraFlight::record() {
  for (const request::Fly& flown : poses_) recording_->moveTo(flown.pose, flown.at, flown.took);
}

// Whether the last pose belongs to a recording that is over: then it is not shown by itself.
bool CameraFlight::switchRecordings() {
  bool isLastRecorded = false;
  for (const request::SetRecording& subscriptions : std::exchange(switches_, {})) {
    if (subscriptions.on && !recording_) {
      if (jobContext_.change(RequestKind::Recording, [&] { beginRecording(subscriptions.at); })) record();
    } else if (!subscriptions.on && recording_) {
      endRecording(subscriptions.at);
      isLastRecorded = !poses_.empty() && poses_.back().at <= subscriptions.at;
    }
  }
  return isLastRecorded;
}

void CameraFlight::settle() {
  if (poses_.empty() && switches_.empty()) return;
  if (jobContext_.isOpen()) {
    if (recording_) record();
    const bool isLastRecorded = switchRecordings();
    if (!poses_.empty() && !isLastRecorded) {
      const CameraPose pose = poses_.back().pose;
      pose_.reset();
      if (transport_.isPlaying())
        pose_ = pose; // of the next frame
      else
        jobContext_.change(RequestKind::Flight, [&] {
          jobContext_.inspector.shot().setCameraTrack({kFreeCamera, 0, {pose}});
        });
    }
  }
  poses_.clear();
  switches_.clear();
}

// What was flown up to here belongs to it, so that the frame on show stays what it is.
void CameraFlight::beginRecording(Clock::time_point at) {
  InspectedShot& shot = jobContext_.inspector.shot();
  const int frame = seekTarget_.frame.value_or(shot.frame()), end = shot.frameCount() - 1;
  const auto [first, last] = transport_.frames();
  if (frame >= end)
    throw Error(say<"cannot record a flight at frame %1, which is the last one: go to another frame">(frame));
  CameraTrack track{"", frame, {shot.cameraPose()}};
  const CameraTrackHandle flown = currentTrack();
  if (flown && flown->firstFrame <= frame) track = *flown;
  track.name = freeName(shot.cameras());
  track.put(frame, shot.cameraPose());
  shot.setCameraTrack(track);
  recorded_ = std::move(track);
  recording_.emplace(frame, frame >= first && frame < last ? last : end, shot.cameraPose(), at);
  recording_->setRate(transport_.framesPerSecond(), at);
  playsAfter_ = transport_.isPlaying();
  transport_.setPlaying(true);
}

void CameraFlight::endRecording(Clock::time_point at) {
  const FlightRecording recording = *std::exchange(recording_, {});
  CameraTrack track = std::move(recorded_);
  int frame = recording.firstFrame() - 1;
  for (const CameraPose& pose : recording.poses(at)) track.put(++frame, pose);
  jobContext_.change(RequestKind::Recording,
                     [&] { jobContext_.inspector.shot().setCameraTrack(std::move(track)); });
  pose_.reset();
  isLaying_ = false;
  seekTarget_.set(frame);
  transport_.setPlaying(playsAfter_);
}

CameraTrackHandle CameraFlight::currentTrack() const {
  const InspectedShot& shot = jobContext_.inspector.shot();
  for (const CameraTrackHandle& track : shot.cameraTracks())
    if (track->name == shot.camera()) return track;
  return nullptr;
}

void CameraFlight::layPose(int frame) {
  if (pose_) layTrack(frame, *pose_);
  pose_.reset();
}

// What is flown starts from where the camera is. Until a recording is done its camera has the poses that were
// on show.
void CameraFlight::layTrack(int frame, const CameraPose& pose) {
  InspectedShot& shot = jobContext_.inspector.shot();
  const std::string name = recording_ ? recorded_.name : kFreeCamera;
  CameraTrack track{name, shot.frame(), {shot.cameraPose()}};
  // One that begins later was begun before somebody jumped here.
  const CameraTrackHandle flown = currentTrack();
  if (flown && flown->name == name && flown->firstFrame <= shot.frame()) track = *flown;
  track.put(frame, pose);
  shot.setCameraTrack(std::move(track));
  // What is known of the frames up to here stays true; of those to come nothing is once they were dropped.
  if (!std::exchange(isLaying_, true)) jobContext_.noteShotChange();
}

void CameraFlight::end() {
  if (recording_) {
    endRecording(jobContext_.now());
    return;
  }
  isLaying_ = false;
  InspectedShot& shot = jobContext_.inspector.shot();
  if (!jobContext_.isOpen() || shot.camera() != kFreeCamera) {
    pose_.reset();
    return;
  }
  const CameraPose pose = pose_.value_or(shot.cameraPose());
  pose_.reset();
  CameraTrack rests{kFreeCamera, 0, {pose}};
  if (*currentTrack() == rests) return;
  if (!jobContext_.attempt(RequestKind::Flight, [&] { shot.setCameraTrack(std::move(rests)); })) return;
  jobContext_.noteChange(RequestKind::Flight);
}

} // namespace taa
