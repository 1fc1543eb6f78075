#include "core/jobs/idle/FlickerMeasuring.h"

#include "core/base/Say.h"

#include <optional>

namespace taa {

bool FlickerMeasuring::isWanted(int lane) const {
  const int wanted = wanted_.flickerSamplesOf(lane);
  if (wanted < 0) return false;
  const std::optional<int> known = desk().inspector.flicker().samples(lane);
  return !known || (wanted > 0 && *known != wanted);
}

void FlickerMeasuring::refine(int lane) {
  desk().inspector.flicker().refine(
      wanted_.flickerSamplesOf(lane),
      desk().progressUntilAny(WorkKind::Flicker, say<"Measuring the flicker">()), lane);
}

} // namespace taa
