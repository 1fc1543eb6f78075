#include "core/scene/camera/CameraTrack.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace taa {

namespace {

constexpr float kFarAway = 1e6f; ///< of a position, world units: farther away floats have no detail
constexpr float kMinFov = 1.0f, kMaxFov = 160.0f; ///< degrees

bool isIn(float value, float least, float most) {
  return value >= least && value <= most; // false for NaN
}

} // namespace

const CameraPose& CameraTrack::at(int frame) const {
  assert(!poses.empty());
  const int last = static_cast<int>(poses.size()) - 1;
  return poses[static_cast<std::size_t>(std::clamp(frame - firstFrame, 0, last))];
}

void CameraTrack::put(int frame, const CameraPose& pose) {
  assert(frame >= firstFrame && !poses.empty());
  const auto index = static_cast<std::size_t>(frame - firstFrame);
  const CameraPose last = poses.back();
  poses.resize(index + 1, last);
  poses[index] = pose;
}

FlownCameras replaced(FlownCameras cameras, const std::optional<CameraTrack>& before,
                      const std::optional<CameraTrack>& after, const std::string& instead) {
  const auto named = [&](const std::optional<CameraTrack>& wanted) {
    return std::ranges::find_if(
        cameras.tracks, [&](const CameraTrack& track) { return wanted && track.name == wanted->name; });
  };
  const auto old = named(before);
  const bool isShown = before ? cameras.camera == before->name : true;
  if (old != cameras.tracks.end() && after)
    *old = *after;
  else if (old != cameras.tracks.end())
    cameras.tracks.erase(old);
  else if (after && named(after) == cameras.tracks.end())
    cameras.tracks.push_back(*after);
  if (isShown) cameras.camera = after ? after->name : instead;
  return cameras;
}

std::optional<int> firstDifference(const CameraTrack& a, const CameraTrack& b) {
  const auto end = [](const CameraTrack& track) {
    return track.firstFrame + static_cast<int>(track.poses.size());
  };
  for (int frame = 0; frame <= std::max(end(a), end(b)); ++frame)
    if (!(a.at(frame) == b.at(frame))) return frame;
  return {};
}

glm::vec3 forwardOf(const CameraPose& pose) {
  const float yaw = glm::radians(pose.yaw), pitch = glm::radians(pose.pitch);
  return {std::sin(yaw) * std::cos(pitch), std::sin(pitch), -std::cos(yaw) * std::cos(pitch)};
}

glm::vec3 rightOf(const CameraPose& pose) {
  const float yaw = glm::radians(pose.yaw);
  return {std::cos(yaw), 0.0f, std::sin(yaw)};
}

CameraState cameraAt(const Scene& scene, const CameraPose& pose, float aspect) {
  CameraState camera;
  const float radius = scene.bounds.radius();
  camera.nearPlane = kNearOfRadius * (std::isfinite(radius) && radius > 0.0f ? radius : 1.0f);
  camera.viewFromWorld =
      glm::lookAt(pose.position, pose.position + forwardOf(pose), glm::vec3(0.0f, 1.0f, 0.0f));
  camera.clipFromView = perspectiveReversed(glm::radians(pose.fovY), aspect, camera.nearPlane);
  return camera;
}

CameraPose poseOf(const CameraState& camera) {
  const glm::mat4 world = glm::inverse(camera.viewFromWorld);
  const glm::vec3 forward = -glm::normalize(glm::vec3(world[2]));
  CameraPose pose;
  pose.position = glm::clamp(glm::vec3(world[3]), glm::vec3(-kFarAway), glm::vec3(kFarAway));
  pose.yaw = glm::degrees(std::atan2(forward.x, -forward.z));
  pose.pitch = std::clamp(glm::degrees(std::asin(std::clamp(forward.y, -1.0f, 1.0f))), -kMaxPitch, kMaxPitch);
  if (!camera.orthographic)
    pose.fovY =
        std::clamp(glm::degrees(2.0f * std::atan(1.0f / camera.clipFromView[1][1])), kMinFov, kMaxFov);
  return pose;
}

void requireNewCamera(const Scene& scene, const std::string& name) {
  const std::vector<std::string> names = cameraNames(scene);
  if (std::ranges::find(names, name) != names.end())
    throw Error(
        say<"the scene has a camera called \"%1\" already; give the path another name">(shownText(name)));
}

void checkCameraTrack(const CameraTrack& track) {
  if (track.name.empty()) throw Error(say<"a camera path needs a name">());
  const std::string name = shownText(track.name);
  if (track.poses.empty()) throw Error(say<"the camera path \"%1\" has no pose">(name));
  if (track.firstFrame < 0) throw Error(say<"the camera path \"%1\" begins at a frame before 0">(name));
  for (std::size_t i = 0; i < track.poses.size(); ++i) {
    const CameraPose& pose = track.poses[i];
    bool isRight = isIn(pose.yaw, -36000.0f, 36000.0f) && isIn(pose.pitch, -kMaxPitch, kMaxPitch) &&
                   isIn(pose.fovY, kMinFov, kMaxFov);
    for (int axis = 0; axis < 3; ++axis) isRight = isRight && isIn(pose.position[axis], -kFarAway, kFarAway);
    if (!isRight)
      throw Error(say<"the camera path \"%1\" has a pose %2 that is out of range: positions within a million "
                      "units, pitch within 89 degrees, field of view 1 to 160 degrees">(name, i));
  }
}

} // namespace taa
