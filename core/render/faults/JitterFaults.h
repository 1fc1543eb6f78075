// Jitter with faults: what a frame is drawn with, and what is reported of it.
#pragma once

#include "core/settings/Settings.h"

#include <glm/vec2.hpp>

#include <functional>

namespace taa {

/// Displacements of image content, px, x right, y down.
struct FaultyJitter {
  glm::vec2 applied{0.0f};  ///< by what the picture is displaced
  glm::vec2 reported{0.0f}; ///< what the resolve believes
};

/// Jitter of a frame of the sequence without faults, px; frames from 0 on.
using JitterOfFrame = std::function<glm::vec2(int frame)>;

/// Whether inputs of the frame are faulty: it lies in the frames that the faults say.
bool isFaultyFrame(const FaultSettings& faults, int frame);

/// `isDrawn`: the picture is drawn for the request. A capture's is drawn already: of it only what is reported
/// can be wrong.
FaultyJitter faultyJitter(const FaultSettings& faults, const JitterOfFrame& given, int frame, bool isDrawn);

} // namespace taa
