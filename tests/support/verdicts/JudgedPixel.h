// What a verdict is concluded from, made by hand.
#pragma once

#include "core/verdict/pixel/PixelVerdict.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cstddef>

namespace taa::test {

/// A pixel of frame 40 that is what it should be, in as many moments as a verdict looks at.
inline VerdictEvidence healthy() {
  VerdictEvidence evidence;
  evidence.error.frame = 40;
  for (int age = 0; age < kVerdictFrames; ++age) {
    SurfaceMoment moment;
    moment.frame = 40 - age;
    moment.resolved = moment.reference = glm::dvec3(0.5);
    twin::at(moment.record, IntermediateId::alpha).x = 0.1f;
    twin::at(moment.record, IntermediateId::historyLength).x = 19.0f;
    evidence.moments.push_back(moment);
    ErrorOfFrame entry;
    entry.frame = moment.frame;
    evidence.error.frames.push_back(entry);
  }
  evidence.error.resolved = evidence.error.reference = glm::dvec3(0.5);
  return evidence;
}

/// Adds an error that came in `age` frames ago and has been shown since.
inline void addError(VerdictEvidence& evidence, ErrorPart part, int age, const glm::dvec3& error) {
  of(evidence.error.frames[static_cast<std::size_t>(age)].split, part) += error;
  of(evidence.error.sum, part) += error;
  evidence.error.resolved += error;
  const std::size_t shown = std::min(evidence.moments.size(), static_cast<std::size_t>(age) + 1);
  for (std::size_t at = 0; at < shown; ++at) evidence.moments[at].resolved += error;
}

} // namespace taa::test
