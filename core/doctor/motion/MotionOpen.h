// Faults of motion that frames would not show: what is not decided is said, each fault by itself.
#pragma once

#include "core/doctor/motion/MotionJudgement.h"
#include "core/settings/Faults.h"

#include <vector>

namespace taa::doctor {

/// Of the table: those that a region's motion may have, for all that its pixels, depth and matrices say.
/// `trials`: those of the evidence.
std::vector<Fault> openFaults(const JudgedRegion& region, const std::vector<MotionTrial>& trials);

/// The same of objects so thin that none of their pixels is looked at.
std::vector<Fault> openFaultsOfUnseen();

/// Adds those of `more` that are not there.
void addFaults(const std::vector<Fault>& more, std::vector<Fault>& faults);

} // namespace taa::doctor
