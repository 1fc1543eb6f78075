// How far a picture is shifted against the one before it, besides motion: what jitter does to both, measured
// by least squares.
#pragma once

#include "core/doctor/frames/DoctorFrame.h"
#include "core/doctor/motion/MotionTrials.h"

#include <glm/vec2.hpp>

#include <optional>

namespace taa::doctor {

/// px: the place of a pixel in the frame before is its center − motion + this. The frame before is warped by
/// the camera's motion where that is known, so that motion vectors have no part in it, else by the motion
/// given. Jitters j of this frame and j' of the one before make it j' − j. What moves by itself counts as
/// outliers. Nothing where there is too little detail.
std::optional<glm::vec2> measureShift(const FrameNeighbors& frames);

} // namespace taa::doctor
