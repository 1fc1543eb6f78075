// What is not told of motion because something else is wrong: findings that may be its doing.
#pragma once

#include "core/doctor/Diagnosis.h"
#include "core/doctor/jitter/JitterCheck.h"

#include <cstddef>

namespace taa::doctor {

// `first`: the finding from which on they are of motion. What is taken back is said not to be decided.

/// Without object numbers depth says where parts of the picture end; coarse depth has them end anywhere.
void withholdParts(std::size_t first, Diagnosis& out);
/// Jitter that nobody knows makes the motion of single regions look wrong by parts of a pixel, and says
/// nothing of jitter in motion.
void withholdMotion(const JitterOutcome& jitter, std::size_t first, Diagnosis& out);
/// A sky that is drawn without the jitter that it is examined by looks as if its motion held jitter, and that
/// of plain and thin things before it. Nothing is taken back where the sky has its jitter.
void withholdSky(std::size_t first, Diagnosis& out);

} // namespace taa::doctor
