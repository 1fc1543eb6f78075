#include "core/measure/StageCosts.h"

#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"

#include <algorithm>

namespace taa {

Settings withCheapest(Settings settings, std::span<const StageInfo> stages) {
  static const Settings kCheapest = preset("minimal").settings;
  for (const Parameter& row : parameters())
    if (std::ranges::find(stages, row.stage, &StageInfo::stage) != stages.end())
      row.set(settings, row.get(kCheapest));
  return settings;
}

CostVerdict StageCost::verdict() const {
  if (isCheapest) return CostVerdict::Cheapest;
  if (ms.median > ms.spread()) return CostVerdict::Clear;
  return ms.median < -ms.spread() ? CostVerdict::Negative : CostVerdict::Noise;
}

std::string verdictWords(const StageCost& cost) {
  switch (cost.verdict()) {
  case CostVerdict::Cheapest:
    return say<"has the cheapest settings, those of Minimal">();
  case CostVerdict::Clear:
    break;
  case CostVerdict::Noise:
    return say<"not above the noise, ± %1 ms">(fixedText(cost.ms.spread(), 3));
  case CostVerdict::Negative:
    return say<"below 0: these settings are cheaper than those of Minimal">();
  }
  return {};
}

} // namespace taa
