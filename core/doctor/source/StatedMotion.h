// What a capture states of motion, and of what motion is held against, jitter, depth and matrices: which of
// it has to be stated otherwise for motion of what rests to be the camera's.
#pragma once

#include "core/capture/format/Manifest.h"
#include "core/doctor/Diagnosis.h"

#include <filesystem>
#include <vector>

namespace taa::doctor {

/// Findings of one or two conventions that are stated otherwise than frames are written, by pixels of a few
/// frames: with them motion is what depth and matrices make it, to the precision that it is stored with, and
/// with those that are stated it is not. These are set to what is stored. Nothing is found where one alone is
/// wrong that pictures tell as well, or where several explain the same. Throws Error.
std::vector<Finding> correctMotion(const std::filesystem::path& folder, capture::Manifest& manifest);

} // namespace taa::doctor
