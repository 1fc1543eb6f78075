// What the doctor says of the motion of all regions: one finding for one fault, wherever it shows.
#pragma once

#include "core/doctor/CaptureInfo.h"
#include "core/doctor/Diagnosis.h"
#include "core/doctor/frames/Regions.h"
#include "core/doctor/motion/MotionEvidence.h"
#include "core/doctor/motion/MotionJudgement.h"

#include <optional>
#include <vector>

namespace taa::doctor {

/// Of all frames that were looked at.
double allPixels(const CaptureInfo& captureInfo, const Diagnosis& out);
/// `allPixels`: these, of which its pixels are a share.
RegionPlace placeOf(const Region& region, const CaptureInfo& captureInfo, double allPixels);

/// One explanation of the motion of all or most of the picture, with the findings that tell it.
struct MotionOfAll {
  MotionTrial trial;
  std::vector<Finding> findings;
};

struct MotionTold {
  std::optional<MotionOfAll> all; ///< where it is told by one explanation
  /// Another previous camera makes the motion given, or another depth: pixels do not tell which.
  bool isOfCameraOrDepth = false;
};

/// Whether motion leads so far at most of the pixels that nothing can be compared.
bool isBeyondPicture(const MotionEvidence& evidence);
/// That it does, and would not in another unit.
Finding unitFinding(const MotionTrial& unit);

/// Adds findings, what is undecided and what is right about the motion of all regions. Expects that motion
/// is known.
MotionTold tellMotion(const MotionEvidence& evidence, const std::vector<Region>& regions,
                      const CaptureInfo& captureInfo, const SilhouettesSeen& silhouettes, Diagnosis& out);

} // namespace taa::doctor
