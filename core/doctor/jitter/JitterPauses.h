// Frames that are drawn without the jitter that is stated for them, where others are drawn with it: no mean
// over all of them shows that.
#pragma once

#include "core/doctor/jitter/JitterTrials.h"

#include <optional>
#include <vector>

namespace taa::doctor {

struct JitterPauses {
  std::vector<int> frames; ///< whose pictures hold no jitter …
  std::vector<int> asked;  ///< … of these, whose shifts are measured
  /// px, in the middle of the pairs that say so: how far measured shifts are from those of what is stated,
  /// and from those of jitter with these pauses.
  double statedPx = 0.0, pausedPx = 0.0;
};

/// Of all ways in which frames may hold the stated jitter or none, the one that is nearest to measured shifts
/// (Viterbi's algorithm). Nothing where it is not clearly nearer than what is stated, or hardly a frame holds
/// any.
std::optional<JitterPauses> jitterPauses(const JitterEvidence& evidence);

} // namespace taa::doctor
