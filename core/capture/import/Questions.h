// Questions about conventions, and what pixels answer: the frame before, moved as a hypothesis says, is most
// like the frame under the right one.
#pragma once

#include "core/base/Progress.h"
#include "core/capture/import/FrameSamples.h"
#include "core/capture/import/Guess.h"

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace taa::capture {

/// Which answers become part of the state that other questions are asked in.
enum class Adopt : std::uint8_t { Best, SureOnes, None };

struct QuestionRules {
  Adopt adopt = Adopt::Best;
  std::set<std::string> fixedPaths; ///< conventions that are not questioned
};

/// Asks all that the samples can say something about; `state` becomes what was adopted. Throws Cancelled.
std::vector<Finding> askPixels(FrameSamples& samples, TestState& state, const QuestionRules& rules,
                               const Progress& progress);

/// Motion that is stated in pixels and shorter than one everywhere, where pixels say clearly another unit,
/// with whatever direction and y axis: `state` becomes that. Nothing where they do not.
std::optional<Finding> askShortMotion(FrameSamples& samples, TestState& state);

/// The twelve starting points by how well their motion and jitter fit.
Finding askStartingPoints(FrameSamples& samples, const TestState& state);

} // namespace taa::capture
