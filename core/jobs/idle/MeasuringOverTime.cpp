#include "core/jobs/idle/MeasuringOverTime.h"

#include "core/base/Say.h"

#include <optional>

namespace taa {

std::vector<OverTime> MeasuringOverTime::kindsOf(int lane) const {
  std::vector<OverTime> kinds;
  for (const OverTime kind : {OverTime::Flicker, OverTime::Parts}) {
    const int subscriptions = subscriptions_.samplesOverTimeOf(kind, lane);
    const std::optional<int> known = jobContext().inspector.overTime().samples(kind, lane);
    if (subscriptions >= 0 && (!known || (subscriptions > 0 && *known != subscriptions)))
      kinds.push_back(kind);
  }
  return kinds;
}

bool MeasuringOverTime::isWanted(int lane) const {
  return !kindsOf(lane).empty();
}

// Kinds that want the same references together: their frames are made once.
void MeasuringOverTime::refine(int lane) {
  std::vector<OverTime> kinds = kindsOf(lane);
  const int samples = subscriptions_.samplesOverTimeOf(kinds.front(), lane);
  std::erase_if(kinds,
                [&](OverTime kind) { return subscriptions_.samplesOverTimeOf(kind, lane) != samples; });
  const auto what =
      kinds.front() == OverTime::Flicker ? say<"Measuring the flicker">() : say<"Splitting the error">();
  jobContext().inspector.overTime().refine(kinds, samples,
                                           jobContext().progressUntilAny(WorkKind::OverTime, what), lane);
}

} // namespace taa
