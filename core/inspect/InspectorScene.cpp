// What of the scene is drawn and from where: cameras, flown ones too, motion modes, classes, hidden objects;
// and where its history starts.
#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/inspect/InspectorParts.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace taa {

std::vector<std::string> InspectedShot::cameras() const {
  std::vector<std::string> names = cameraNames(scene());
  for (const CameraTrackHandle& track : parts_->subject.tracks) names.push_back(track->name);
  return names;
}

const std::string& InspectedShot::camera() const {
  return parts_->subject.camera;
}

void InspectedShot::setCamera(const std::string& name) {
  assert(parts_->isOpen());
  if (name == camera()) return;
  Subject next = parts_->subject;
  next.camera = name;
  const std::vector<bool> changed(next.lanes.size(), true);
  parts_->redraw(std::move(next), changed, false);
}

const std::vector<MotionOverride>& InspectedShot::motionModes() const {
  return parts_->subject.motionModes;
}

void InspectedShot::setMotionModes(const std::vector<MotionOverride>& modes) {
  assert(parts_->isOpen());
  if (modes == motionModes()) return;
  checkMotionOverrides(scene(), modes);
  Subject next = parts_->subject;
  next.motionModes = modes;
  const std::vector<bool> changed(next.lanes.size(), true);
  parts_->redraw(std::move(next), changed, true);
}

const ObjectFilter& InspectedShot::objectFilter() const {
  return parts_->subject.filter;
}

void InspectedShot::setObjectFilter(const ObjectFilter& filter) {
  assert(parts_->isOpen());
  if (filter == objectFilter()) return;
  checkObjectFilter(scene(), filter);
  Subject next = parts_->subject;
  next.filter = filter;
  const std::vector<bool> changed(next.lanes.size(), true);
  parts_->redraw(std::move(next), changed, true);
}

const std::vector<ClassOverride>& InspectedShot::objectClasses() const {
  return parts_->subject.objectClasses;
}

void InspectedShot::setObjectClasses(const std::vector<ClassOverride>& classes) {
  assert(parts_->isOpen());
  if (classes == objectClasses()) return;
  checkClassOverrides(scene(), classes);
  Subject next = parts_->subject;
  next.objectClasses = classes;
  const std::vector<bool> changed(next.lanes.size(), true);
  parts_->redraw(std::move(next), changed, true);
}

const std::vector<int>& InspectedShot::restarts() const {
  return parts_->subject.restarts;
}

void InspectedShot::setRestarts(std::vector<int> frames) {
  assert(parts_->isOpen());
  for (const int frame : frames)
    if (frame < 0 || frame >= frameCount())
      throw Error(say<"cannot restart the history at frame %1: the shot has frames 0 to %2">(
          frame, frameCount() - 1));
  std::ranges::sort(frames);
  frames.erase(std::ranges::unique(frames).begin(), frames.end());
  std::erase(frames, 0); // history starts there anyway
  std::vector<int> changed;
  std::ranges::set_symmetric_difference(frames, restarts(), std::back_inserter(changed));
  if (changed.empty()) return;
  Subject next = parts_->subject;
  next.restarts = std::move(frames);
  parts_->aside.clear();
  parts_->follow(std::move(next), changed.front(), true);
}

const std::vector<CameraTrackHandle>& InspectedShot::cameraTracks() const {
  return parts_->subject.tracks;
}

void InspectedShot::setCameraTrack(CameraTrack track) {
  assert(parts_->isOpen());
  checkCameraTrack(track);
  if (std::ranges::count(cameraNames(scene()), track.name) > 0)
    throw Error(say<"the scene has a camera called \"%1\" already; give the path another name">(track.name));
  Subject next = parts_->subject;
  const CameraTrackHandle old = next.track();
  const auto made = std::make_shared<const CameraTrack>(std::move(track));
  const auto known = std::ranges::find_if(
      next.tracks, [&](const CameraTrackHandle& handle) { return handle->name == made->name; });
  if (known == next.tracks.end())
    next.tracks.push_back(made);
  else
    *known = made;
  next.camera = made->name;
  constexpr int kNever = std::numeric_limits<int>::max();
  parts_->follow(std::move(next), old ? firstDifference(*old, *made).value_or(kNever) : 0);
}

void InspectedShot::setFlownCameras(const FlownCameras& cameras) {
  assert(parts_->isOpen());
  Subject next = parts_->subject;
  next.tracks.clear();
  std::vector<std::string> names = cameraNames(scene());
  for (const CameraTrack& track : cameras.tracks) {
    checkCameraTrack(track);
    if (std::ranges::count(names, track.name) > 0)
      throw Error(say<"there is a camera called \"%1\" already; give the path another name">(track.name));
    names.push_back(track.name);
    next.tracks.push_back(std::make_shared<const CameraTrack>(track));
  }
  if (std::ranges::count(names, cameras.camera) == 0)
    throw Error(say<"there is no camera called \"%1\"">(cameras.camera));
  next.camera = cameras.camera;
  const CameraTrackHandle now = next.track(), old = parts_->subject.track();
  const bool isSame = now && old ? now->firstFrame == old->firstFrame && now->poses == old->poses
                                 : !now && !old && next.camera == camera();
  parts_->follow(std::move(next), isSame ? std::numeric_limits<int>::max() : 0);
}

CameraPose InspectedShot::cameraPose() const {
  if (const CameraTrackHandle track = parts_->subject.track()) return track->at(frame());
  const float aspect = static_cast<float>(width()) / static_cast<float>(height());
  return poseOf(cameraAt(scene(), camera(), info().time, aspect));
}

} // namespace taa
