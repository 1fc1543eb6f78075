// Cameras that a person flies: a pose, and a path that has one for each frame.
#pragma once

#include "core/scene/Pose.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace taa {

/// Where somebody stands and looks; y is up, nothing rolls.
struct CameraPose {
  glm::vec3 position{0.0f}; ///< world
  float yaw = 0.0f;         ///< degrees; 0 looks along −z, positive to the right
  float pitch = 0.0f;       ///< degrees above the horizon, −kMaxPitch to kMaxPitch
  float fovY = 45.0f;       ///< degrees
  bool operator==(const CameraPose&) const = default;
};

/// Near plane of fitted paths and flown cameras, so that depth reads the same: reversed float depth keeps its
/// precision with one this close.
inline constexpr float kNearOfRadius = 0.01f;

/// Straight up and down have no yaw.
inline constexpr float kMaxPitch = 89.0f;

/// A camera path by poses: frame n has poses[n − firstFrame]; before the first and after the last it rests.
struct CameraTrack {
  std::string name;
  int firstFrame = 0;
  std::vector<CameraPose> poses; ///< at least one
  bool operator==(const CameraTrack&) const = default;

  const CameraPose& at(int frame) const;
  /// Changes the pose of `frame`, not before the first one, and of all after it.
  void put(int frame, const CameraPose& pose);
};
using CameraTrackHandle = std::shared_ptr<const CameraTrack>;

/// Cameras that were flown, and the one that is looked through: one of them or of the scene's.
struct FlownCameras {
  std::vector<CameraTrack> tracks;
  std::string camera;
  bool operator==(const FlownCameras&) const = default;
};
/// One in place of another: nothing before it adds one, nothing after it removes one. What was looked through
/// goes on to be, or else `instead`; what is added is looked through.
FlownCameras replaced(FlownCameras cameras, const std::optional<CameraTrack>& before,
                      const std::optional<CameraTrack>& after, const std::string& instead);

/// Name of the camera that is flown and not recorded.
inline constexpr const char* kFreeCamera = "free";

/// The first frame at which two tracks differ; nothing where they never do.
std::optional<int> firstDifference(const CameraTrack& a, const CameraTrack& b);

/// Unit vector that a pose looks along, and the one to its right.
glm::vec3 forwardOf(const CameraPose& pose);
glm::vec3 rightOf(const CameraPose& pose);

/// The camera at a pose; its near plane is that of the paths fitted to the scene.
CameraState cameraAt(const Scene& scene, const CameraPose& pose, float aspect);

/// The pose that looks as a camera does, as far as poses can: without its roll, in perspective.
CameraPose poseOf(const CameraState& camera);

/// Throws Error where a camera of the scene's own is called so already.
void requireNewCamera(const Scene& scene, const std::string& name);

/// Throws Error that says what is wrong with it: no pose, numbers that are none or out of their range.
void checkCameraTrack(const CameraTrack& track);

} // namespace taa
