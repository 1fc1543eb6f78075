// What a sequence of jitter is worth, whatever pictures make of it: its mean, its range, its period.
#pragma once

#include "core/doctor/Diagnosis.h"

#include <glm/vec2.hpp>

#include <map>
#include <optional>

namespace taa::doctor {

struct SequenceFacts {
  int frames = 0;
  /// Frames after which all of it repeats, of which it shows one and four frames, or two, at least; none: it
  /// does not.
  std::optional<int> period;
  glm::dvec2 meanPx{0.0};   ///< over whole periods
  double spreadPx = 0.0;    ///< standard deviation, that of both axes
  glm::dvec2 middlePx{0.0}; ///< between the least and the most of all
  double beyondShare = 0.0; ///< of frames in which x or y is more than half a pixel
  double longestPx = 0.0;   ///< of |x| and |y|
};

/// Of frames that follow each other; px, displacement of content.
SequenceFacts sequenceFacts(const std::map<int, glm::vec2>& jitterPx);

/// Adds a finding for a sequence of two places, whatever pictures hold of it.
void tellShort(const std::map<int, glm::vec2>& jitterPx, Diagnosis& out);

/// Adds what is wrong with a sequence that pictures hold, and what is worth knowing of it. It says nothing of
/// one that is always the same.
void tellSequence(const std::map<int, glm::vec2>& jitterPx, Diagnosis& out);

} // namespace taa::doctor
