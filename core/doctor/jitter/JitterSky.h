// Whether the sky is drawn with the jitter that all else is drawn with.
#pragma once

#include "core/doctor/Diagnosis.h"
#include "core/doctor/jitter/JitterTrials.h"

#include <cstddef>
#include <vector>

namespace taa::doctor {

/// Adds what is wrong or not decided; nothing of a sky that is small. `trial`: what jitter the world has.
void tellSky(const JitterEvidence& evidence, const std::vector<JitterTrial>& trials, std::size_t trial,
             const RegionPlace& place, Diagnosis& out);

} // namespace taa::doctor
