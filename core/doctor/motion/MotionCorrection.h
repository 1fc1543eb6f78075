// Settings that make motion right which an explanation fits.
#pragma once

#include "core/doctor/motion/MotionTrials.h"

#include <string>
#include <vector>

namespace taa::doctor {

/// As --set takes them; empty: what is wrong cannot be undone by any. Where motion was not written, or was
/// made with another camera, it becomes the camera's: what moves by itself has none of its own then.
std::vector<std::string> motionCorrection(const MotionTrial& trial);

} // namespace taa::doctor
