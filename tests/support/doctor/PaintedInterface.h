// A bar with a grid over painted frames: an interface that is drawn before TAA.
#pragma once

#include "core/doctor/frames/DoctorFrame.h"

#include <glm/vec2.hpp>

namespace taa::test {

inline constexpr int kBarTop = 56, kBarBottom = 80; ///< rows, over ground and board

/// Draws it, moved by `movedPx`.
void paintInterface(doctor::DoctorFrame& frame, const glm::vec2& movedPx);

} // namespace taa::test
