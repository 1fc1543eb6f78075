#include "core/jobs/idle/MeasuringOverTime.h"

#include "core/base/Say.h"

#include <optional>

namespace taa {

std::vector<OverTime> MeasuringOverTime::kindsOf(int lane) const {
  std::vector<OverTime> kinds;
  for (const OverTime kind : {OverTime::Flicker, OverTime::Parts}) {
    const int wanted = wanted_.samplesOverTimeOf(kind, lane);
    const std::optional<int> known = desk().inspector.overTime().samples(kind, lane);
    if (wanted >= 0 && (!known || (wanted > 0 && *known != wanted))) kinds.push_back(kind);
  }
  return kinds;
}

bool MeasuringOverTime::isWanted(int lane) const {
  return !kindsOf(lane).empty();
}

// Kinds that want the same references together: their frames are made once.
void MeasuringOverTime::refine(int lane) {
  std::vector<OverTime> kinds = kindsOf(lane);
  const int samples = wanted_.samplesOverTimeOf(kinds.front(), lane);
  std::erase_if(kinds, [&](OverTime kind) { return wanted_.samplesOverTimeOf(kind, lane) != samples; });
  const auto what =
      kinds.front() == OverTime::Flicker ? say<"Measuring the flicker">() : say<"Splitting the error">();
  desk().inspector.overTime().refine(kinds, samples, desk().progressUntilAny(WorkKind::OverTime, what), lane);
}

} // namespace taa
