// What is wished for of the scene, and the camera that is flown.
#pragma once

#include "core/gl/Texture.h"
#include "core/scene/ObjectClass.h"
#include "core/scene/ObjectFilter.h"
#include "core/scene/camera/CameraTrack.h"
#include "core/scene/camera/FlightRecording.h"

#include <glm/vec2.hpp>

#include <optional>
#include <string>
#include <vector>

namespace taa {

/// Where the camera was flown to, by the clock of whoever flies.
struct FlownPose {
  CameraPose pose;
  FlightRecording::Clock::time_point at;    ///< it got there
  FlightRecording::Clock::duration took{0}; ///< of which it was moving for so long
};

struct RecordingWish {
  bool on = false;
  FlightRecording::Clock::time_point at; ///< it was asked for
};

/// A part of Wishes.
struct SceneWishes {
  std::optional<ObjectFilter> filter;
  std::vector<FlownPose> poses; ///< to fly to one after the other: the last one is shown, a recording has all
  std::optional<RecordingWish> recording;
  std::optional<FlownCameras> cameras; ///< instead of all there are
  std::vector<CameraTrack> tracks;     ///< to add after that; the last one is looked through
  std::optional<std::vector<int>> located;
  std::optional<std::vector<ClassOverride>> classes;
  std::optional<std::vector<int>> restarts; ///< frames

  bool changesCamera() const { return !poses.empty() || cameras || !tracks.empty(); }
  bool isEmpty() const { return !endReplay() && !located; }
  /// Whether going to a frame is of no use any more.
  bool endReplay() const { return filter || changesCamera() || recording || classes || restarts; }
};

/// The camera in somebody's hands.
struct Flight {
  std::optional<CameraPose> pose; ///< that the next frame is given
  bool isLaying = false; ///< frames after the one on show get poses: what was known of them is dropped
  std::optional<FlightRecording> recording;
  CameraTrack recorded; ///< what it adds to: its name, and what was flown before it
  bool playsAfter = false;
};

/// Where objects are seen on a frame.
struct ObjectArea {
  std::vector<int> objects;  ///< that were asked for, by their numbers
  int frame = 0, pixels = 0; ///< 0: not seen
  glm::ivec2 pixel{0};       ///< one of them, near their middle
  gl::Rect box;
};

} // namespace taa
