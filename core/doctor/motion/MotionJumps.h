// Motion that is right but for one frame: an object that comes back with an old transform, a matrix that was
// never set.
#pragma once

#include "core/doctor/CaptureInfo.h"
#include "core/doctor/Diagnosis.h"
#include "core/doctor/frames/Regions.h"
#include "core/doctor/motion/MotionEvidence.h"

#include <optional>
#include <vector>

namespace taa::doctor {

/// The frame in which a region's motion alone is much longer than before and after, and fits its pixels much
/// worse than the motion of the frame before or after does. None: there is none, or more than one.
std::optional<int> jumpOf(const RegionEvidence& evidence);

/// At the silhouettes of what moves, motion is that of where it was a frame ago; see isLateAtSilhouettes().
Finding lateFinding();

/// Adds a finding where regions jump. `allPixels`: of all frames that were looked at.
void tellJumps(const MotionEvidence& evidence, const std::vector<Region>& regions,
               const CaptureInfo& captureInfo, double allPixels, Diagnosis& out);

} // namespace taa::doctor
