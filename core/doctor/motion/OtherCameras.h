// Previous cameras that an engine may have made motion with instead of the one that it had: another one for
// everything that rests in the world.
#pragma once

#include "core/doctor/frames/DoctorFrame.h"

#include <glm/mat4x4.hpp>

#include <optional>

namespace taa::doctor {

/// Previous clip from clip, both without jitter, of a frame.
struct OtherCameras {
  std::optional<glm::mat4> turned; ///< the previous camera, turned: by what fits the motion given
  std::optional<glm::mat4> beside; ///< the previous camera, moved: likewise
  /// Where it is moved along its own way, how much of that is in motion: 0.6 where motion is made with
  /// distances 1/0.6 times as far.
  std::optional<double> wayShare;
  double movedByM = 0.0;             ///< of `beside` …
  bool isMovedAside = false;         ///< … along the picture's x, as views of two eyes stand
  std::optional<glm::mat4> mirrored; ///< by a plane of the world through its origin
  std::optional<glm::mat4> identity; ///< a matrix that was never set
  std::optional<glm::mat4> unzoomed; ///< the previous view with this frame's projection, which is another one
  std::optional<glm::mat4> unmoved;  ///< the previous camera's rotation where this one stands; its place …
  std::optional<glm::mat4> unturned; ///< … with this one's rotation
};

/// Those that a frame's cameras make, where the motion given is not the camera's; else and without cameras
/// none. Turned and moved ones are there only where they make nearly all of the motion given.
OtherCameras otherCameras(const DoctorFrame& frame);

} // namespace taa::doctor
