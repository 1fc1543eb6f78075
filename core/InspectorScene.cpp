// What of the scene is drawn and from where: cameras, flown ones too, motion modes, hidden objects.
#include "core/Inspector.h"
#include "core/InspectorParts.h"
#include "core/base/Error.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace taa {

std::vector<std::string> Inspector::cameras() const {
  std::vector<std::string> names = cameraNames(scene());
  for (const CameraTrackHandle& track : parts_->subject.tracks) names.push_back(track->name);
  return names;
}

const std::string& Inspector::camera() const {
  return parts_->subject.camera;
}

void Inspector::setCamera(const std::string& name) {
  assert(parts_->isOpen());
  if (name == camera()) return;
  Subject next = parts_->subject;
  next.camera = name;
  const std::vector<bool> changed(next.lanes.size(), true);
  parts_->redraw(std::move(next), changed, false);
}

const std::vector<MotionOverride>& Inspector::motionModes() const {
  return parts_->subject.motionModes;
}

void Inspector::setMotionModes(const std::vector<MotionOverride>& modes) {
  assert(parts_->isOpen());
  if (modes == motionModes()) return;
  checkMotionOverrides(scene(), modes);
  Subject next = parts_->subject;
  next.motionModes = modes;
  const std::vector<bool> changed(next.lanes.size(), true);
  parts_->redraw(std::move(next), changed, true);
}

const ObjectFilter& Inspector::objectFilter() const {
  return parts_->subject.filter;
}

void Inspector::setObjectFilter(const ObjectFilter& filter) {
  assert(parts_->isOpen());
  if (filter == objectFilter()) return;
  checkObjectFilter(scene(), filter);
  Subject next = parts_->subject;
  next.filter = filter;
  const std::vector<bool> changed(next.lanes.size(), true);
  parts_->redraw(std::move(next), changed, true);
}

const std::vector<CameraTrackHandle>& Inspector::cameraTracks() const {
  return parts_->subject.tracks;
}

void Inspector::setCameraTrack(CameraTrack track) {
  assert(parts_->isOpen());
  checkCameraTrack(track);
  if (std::ranges::count(cameraNames(scene()), track.name) > 0)
    throw Error("the scene has a camera called \"" + track.name + "\" already; give the path another name");
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

CameraPose Inspector::cameraPose() const {
  if (const CameraTrackHandle track = parts_->subject.track()) return track->at(frame());
  const float aspect = static_cast<float>(width()) / static_cast<float>(height());
  return poseOf(cameraAt(scene(), camera(), info().time, aspect));
}

} // namespace taa
