// What the doctor says of an engine's resolve: which mistake explains its output, and which preset of this
// program is nearest to it.
#pragma once

#include "core/doctor/Diagnosis.h"
#include "core/doctor/resolve/ResolveEvidence.h"

namespace taa::doctor {

/// Adds findings, what is undecided and what is right about the resolve. `areInputsRight`: nothing was found
/// of the frames that it is made of; else only what fits exactly is told, as the engine can have had others.
void tellResolve(const ResolveEvidence& evidence, bool areInputsRight, Diagnosis& out);

} // namespace taa::doctor
