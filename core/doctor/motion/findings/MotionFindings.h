// What the doctor says of the motion of all regions: one finding for one fault, wherever it shows.
#pragma once

#include "core/doctor/Diagnosis.h"
#include "core/doctor/Patient.h"
#include "core/doctor/frames/Regions.h"
#include "core/doctor/motion/MotionEvidence.h"
#include "core/doctor/motion/MotionJudgement.h"

#include <optional>
#include <vector>

namespace taa::doctor {

/// `allPixels`: of all frames that were looked at.
RegionPlace placeOf(const Region& region, const Patient& patient, double allPixels);

/// One explanation of the motion of all or most of the picture, with the finding that tells it.
struct MotionOfAll {
  MotionTrial trial;
  Finding finding;
};

/// Adds findings, what is undecided and what is right about the motion of all regions. Expects that motion
/// is known. Returns what the motion of all or most of the picture is told by, where that is one explanation.
std::optional<MotionOfAll> tellMotion(const MotionEvidence& evidence, const std::vector<Region>& regions,
                                      const Patient& patient, const RimsSeen& rims, Diagnosis& out);

} // namespace taa::doctor
