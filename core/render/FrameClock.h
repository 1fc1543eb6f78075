// Time as a function of the frame's number.
#pragma once

#include "core/scene/Scene.h"

namespace taa {

/// Seconds since frame 0.
double frameTime(const Scene& scene, int frame);

/// Whether no history may be used: the first frame, and cuts.
bool startsHistory(const Scene& scene, int frame);

/// The frame motion refers to: the one before, or the frame itself where history starts.
int previousFrame(const Scene& scene, int frame);

} // namespace taa
