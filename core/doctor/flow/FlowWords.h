// What was fitted to motion, or that nothing was, as a finding.
#pragma once

#include "core/doctor/Diagnosis.h"
#include "core/doctor/Patient.h"
#include "core/doctor/flow/FlowFit.h"

namespace taa::doctor {

// Each names a finding that has regions and numbers, and an example as its change.
void nameByFit(const FlowFit& fit, const Patient& patient, Finding& finding);
/// Of explainingWithoutRoot().
void nameWithoutRoot(const FlowFit& fit, Finding& finding);
/// Pictures before a frame are missing: by the factor of its motion.
void nameMissing(int frame, const FlowFit& fit, Finding& finding);
void nameUnknown(Finding& finding);

} // namespace taa::doctor
