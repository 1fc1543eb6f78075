// Frames with what was found made right, so that the rest can be looked at: what is wrong in one plane makes
// others look wrong.
#pragma once

#include "core/doctor/depth/DepthCheck.h"
#include "core/doctor/frames/DoctorFrame.h"
#include "core/doctor/jitter/JitterCheck.h"
#include "core/doctor/motion/MotionTrials.h"

#include <glm/vec2.hpp>

#include <map>

namespace taa::doctor {

/// With the jitter that their pictures hold. A frame whose own jitter, or that of the one before, is not
/// known is compared with nothing. `first`: the first frame; `isDepthJittered`: depth was drawn with it.
FrameReader withJitter(FrameReader read, JitterCorrector corrector, int first, bool isDepthJittered);

/// With the depth that follows from the stored one.
FrameReader withDepth(FrameReader read, DepthRelation relation);
/// With matrices whose y goes the other way.
FrameReader withFlippedMatrices(FrameReader read);
/// As of a capture without depth, where that says nothing; cameras say nothing without it.
FrameReader withoutDepth(FrameReader read);

/// Whether one frame's motion and jitter say what all of its motion should be.
bool correctsAlone(const MotionTrial& trial);
/// With the motion that an explanation makes of the one given. `stated`: jitter of all frames. Expects
/// correctsAlone().
FrameReader withMotion(FrameReader read, MotionTrial trial, std::map<int, glm::vec2> stated);

} // namespace taa::doctor
