// What of a source is asked for besides a frame's number.
#pragma once

#include "core/gl/Texture.h"
#include "core/scene/MotionMode.h"
#include "core/scene/ObjectClass.h"
#include "core/scene/ObjectFilter.h"
#include "core/scene/camera/CameraTrack.h"
#include "core/settings/Settings.h"

#include <glm/vec2.hpp>

#include <optional>
#include <string>
#include <vector>

namespace taa {

/// What to draw besides the frame's number.
struct FrameRequest {
  std::string camera;             ///< a path of cameraNames()
  int width = 1280, height = 720; ///< of the picture; drawn at inputs.renderScale of it
  JitterSettings jitter;
  InputSettings inputs;
  std::vector<MotionOverride> motionModes = {}; ///< of objects by name; others keep their node's
  ObjectFilter filter = {};
  CameraTrackHandle track = nullptr;      ///< looked through instead of `camera`
  std::optional<glm::vec2> jitterPx = {}; ///< instead of what the sequence of `jitter` says
  std::optional<int> sample = {}; ///< of a reference, each with noise of its own; none: noise is the frame's
  std::vector<ClassOverride> objectClasses = {}; ///< of objects by name; others have what moves them
  std::vector<int> restarts = {}; ///< frames that use no history besides those where the shot is cut
  /// Texels that are wanted, as if all were drawn; others hold anything. A capture draws all. Default: all.
  std::optional<gl::Rect> part = {};
  bool movesOn = false;        ///< motion is that to the frame after, negated, instead of from the one before
  bool untestedMotion = false; ///< what moves writes its motion where it is hidden, too
  FaultSettings faults = {};   ///< of what is given; who draws knows nothing of them
  bool operator==(const FrameRequest&) const = default;
};

} // namespace taa
