// Values of motion that are no motion: marks of what was not written, and of what has no previous position.
#pragma once

#include "core/doctor/CaptureInfo.h"
#include "core/doctor/Diagnosis.h"
#include "core/doctor/frames/Regions.h"
#include "core/doctor/motion/MotionEvidence.h"

#include <vector>

namespace taa::doctor {

/// Whether nearly all motion of a region is longer than the picture and one value, frame after
/// frame: nothing moves so.
bool isUnwrittenMark(const RegionEvidence& evidence);
/// Whether nearly all of a region is said to have no previous position, frame after frame, though it fits
/// what was there before, and rests on the screen as far as cameras tell.
bool isKeptAsMissing(const RegionEvidence& evidence);

/// Adds a finding for each of the two. `allPixels`: of all frames that were looked at.
void tellMarks(const MotionEvidence& evidence, const std::vector<Region>& regions,
               const CaptureInfo& captureInfo, double allPixels, Diagnosis& out);

} // namespace taa::doctor
