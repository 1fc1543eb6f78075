// How a camera moves that is flown by keys and mouse.
#pragma once

#include "core/scene/camera/CameraTrack.h"

namespace taa::app {

/// What keys ask for, −1 to 1 each.
struct FlightKeys {
  int right = 0, up = 0, forward = 0;
  bool isAny() const { return right != 0 || up != 0 || forward != 0; }
};

/// The pose after moving straight for `distance` world units; sideways, up and forward together are no
/// faster.
CameraPose moved(const CameraPose& pose, const FlightKeys& keys, float distance);
/// The pose after a drag by logical pixels in a view that is `height` of them high, which looks where the
/// mouse goes.
CameraPose turned(const CameraPose& pose, double dx, double dy, double height);

/// World units a second that the wheel chooses from, around what suits a scene of this radius.
float firstSpeed(float radius);
float changedSpeed(float speed, double notches, float radius);

} // namespace taa::app
