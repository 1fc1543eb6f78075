// What a finding about motion rests on, as a sentence and as what each explanation leaves.
#pragma once

#include "core/doctor/Diagnosis.h"
#include "core/doctor/motion/MotionGroups.h"

#include <vector>

namespace taa::doctor {

/// Sets reason, measure and residuals: of depth and matrices, of outlines, or of pixels.
void tellEvidence(const FaultGroup& group, const std::vector<MotionTrial>& trials, Finding& out);

} // namespace taa::doctor
