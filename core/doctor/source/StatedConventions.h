// What a capture states of its frames against what it holds: numbers that cannot be what they are said to be,
// whatever pictures show.
#pragma once

#include "core/capture/format/Manifest.h"
#include "core/doctor/Diagnosis.h"

#include <filesystem>
#include <vector>

namespace taa::doctor {

/// A finding for each convention that what is stored contradicts; these are set to what is stored, so that
/// all else can be examined. Of one frame from the middle, but for jitter in projections, which all say.
/// Throws Error.
std::vector<Finding> correctContradicted(const std::filesystem::path& folder, capture::Manifest& manifest);

} // namespace taa::doctor
