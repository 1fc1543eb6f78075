// What a stage's settings cost more than the cheapest ones: the resolve against itself with the values that
// preset Minimal has for that stage.
//
// What two stages save together is not what each saves: the costs do not add up to that of the whole.
#pragma once

#include "core/gl/PassTimer.h"
#include "core/measure/PairedTimes.h"
#include "core/settings/Settings.h"
#include "core/settings/Stage.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace taa {

/// Those whose settings the resolve carries out; those before them change what is drawn.
inline constexpr std::span<const StageInfo> kCostStages =
    kResolveStages.subspan(static_cast<std::size_t>(Stage::DilateMotion));

/// `settings` with the cheapest ones of `stages`. They are those of preset Minimal, which leaves every stage
/// its work: without a box to clamp to, say, the compiler would leave the neighborhood out as well.
Settings withCheapest(Settings settings, std::span<const StageInfo> stages);

enum class CostVerdict {
  Cheapest, ///< has the cheapest settings: 0, not measured
  Clear,    ///< above 0 by more than its spread
  Noise,    ///< within it: nothing is known but how large it can be at most
  Negative  ///< below 0 by more than its spread: cheaper than Minimal's
};

struct StageCost {
  Stage stage = Stage::Jitter;
  Measured ms; ///< differences of paired times
  bool isCheapest = false;
  CostVerdict verdict() const;
};

/// Of one frame of one lane. `stages`: kCostStages.
struct StageCosts {
  int frame = 0, width = 0, height = 0, rounds = 0;
  gl::TimingMethod method = gl::TimingMethod::Finish;
  Measured whole, cheapest; ///< ms of the resolve, and with the cheapest settings of all stages
  std::vector<StageCost> stages;
};

/// What a verdict means, in a sentence for people; empty: nothing but the number.
std::string verdictWords(const StageCost& cost);

} // namespace taa
