// What was fitted to motion, or that nothing was, as a finding.
#pragma once

#include "core/doctor/CaptureInfo.h"
#include "core/doctor/Diagnosis.h"
#include "core/doctor/flow/FlowFit.h"
#include "core/doctor/flow/FlowLength.h"
#include "core/doctor/motion/MotionWords.h"

#include <string>
#include <vector>

namespace taa::doctor {

// Each names a finding that has regions and numbers, and an example as its change, which stays behind it.
void nameMeasured(const FaultWords& fault, Finding& finding);
void nameByFit(const FlowFit& fit, const CaptureInfo& captureInfo, Finding& finding);
/// Of explainingWithoutRoot().
void nameWithoutRoot(const FlowFit& fit, Finding& finding);
/// Pictures before a frame are missing: by the factor of its motion.
void nameMissing(const std::string& frame, const FlowFit& fit, Finding& finding);
void nameUnknown(Finding& finding);

/// That motion is shorter than a pixel everywhere, and pictures move by so many times as much: in a unit that
/// the fit says, or by its factors; then what is wrong with the axes.
std::vector<Finding> lengthFindings(const FittedLength& length, const MotionTrial& trial,
                                    const CaptureInfo& captureInfo);

} // namespace taa::doctor
