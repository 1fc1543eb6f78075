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
enum class Adopt : std::uint8_t { Best, SureOnes };

struct QuestionRules {
  Adopt adopt = Adopt::Best;
  std::set<std::string> fixedPaths; ///< conventions that are not questioned
  /// Of motion and jitter, tried as they are beside all combinations where the best is adopted.
  std::vector<Conventions> starts = {};
  /// Of motion and jitter, adopted wherever pixels do not say clearly something else.
  const Conventions* prior = nullptr;
  /// In whose words lengths are said, and whose encoding is not questioned; null: the state itself is asked.
  const Conventions* stated = nullptr;
};

/// Asks all that the samples can say something about; `state` becomes what was adopted. Throws Cancelled.
std::vector<Finding> askPixels(FrameSamples& samples, TestState& state, const QuestionRules& rules,
                               const Progress& progress);

/// Asks about conventions that are stated: each question where all others have the answer that pixels give
/// them, for a sign or a unit that is wrong hides or feigns others. `state` becomes these answers. Throws
/// Cancelled.
std::vector<Finding> askStated(FrameSamples& samples, TestState& state, const Progress& progress);

/// Marks the answers that are stated, wherever they were asked.
void chooseStated(std::vector<Finding>& findings, const Conventions& stated);

/// The twelve starting points by how well their motion and jitter fit.
Finding askStartingPoints(FrameSamples& samples, const TestState& state);

} // namespace taa::capture
