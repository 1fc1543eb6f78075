// Stage 8, blend weight: how much the current frame counts.
#include "core/taa/reference/Stages.h"

namespace taa::reference {

Weights weigh(const WeightSettings& settings, float historyLength, RejectReason reason) {
  Weights result;
  const bool isConstant = settings.source == AlphaSource::Constant;
  result.base = isConstant ? settings.alpha : 1.0f / (historyLength + 1.0f);
  result.floor = isConstant ? 0.0f : settings.minimum;
  result.invalid = reason == RejectReason::Kept ? 0.0f : 1.0f;
  const float larger = result.base > result.floor ? result.base : result.floor;
  result.alpha = larger > result.invalid ? larger : result.invalid;
  return result;
}

} // namespace taa::reference
