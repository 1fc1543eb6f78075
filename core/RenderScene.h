// What is wished for of the scene, and the camera that is flown.
#pragma once

#include "core/gl/Texture.h"
#include "core/scene/CameraTrack.h"
#include "core/scene/ObjectClass.h"
#include "core/scene/ObjectFilter.h"

#include <glm/vec2.hpp>

#include <optional>
#include <string>
#include <vector>

namespace taa {

/// A part of Wishes.
struct SceneWishes {
  std::optional<ObjectFilter> filter;
  std::optional<CameraPose> pose; ///< to fly to
  std::optional<bool> recording;
  std::optional<FlownCameras> cameras; ///< instead of all there are
  std::vector<CameraTrack> tracks;     ///< to add after that; the last one is looked through
  std::optional<std::vector<int>> located;
  std::optional<std::vector<ClassOverride>> classes;
  std::optional<std::vector<int>> restarts; ///< frames

  bool isEmpty() const { return !endReplay() && !located; }
  /// Whether going to a frame is of no use any more.
  bool endReplay() const {
    return filter || pose || recording || cameras || !tracks.empty() || classes || restarts;
  }
};

/// The camera in somebody's hands.
struct Flight {
  std::optional<CameraPose> pose; ///< that the next frame is given
  std::string recorded;           ///< the track that poses are kept in; empty: none
  bool isLaying = false; ///< frames after the one on show get poses: what was known of them is dropped
};

/// Where objects are seen on a frame.
struct ObjectArea {
  std::vector<int> objects;  ///< that were asked for, by their numbers
  int frame = 0, pixels = 0; ///< 0: not seen
  glm::ivec2 pixel{0};       ///< one of them, near their middle
  gl::Rect box;
};

} // namespace taa
