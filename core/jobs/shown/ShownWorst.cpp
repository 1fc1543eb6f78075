#include "core/jobs/shown/ShownWorst.h"

#include "core/inspect/WorstOfShot.h"

#include <optional>
#include <utility>

namespace taa {

// Somebody makes the row, or draws the reference that it is made of, for as long as it is wanted.
bool ShownWorst::isUnderWay() const {
  const int lane = subscriptions_.worst->lane;
  const IntermediateId row = WorstOfShot::rowOf(subscriptions_.worst->row, subscriptions_.worst->step);
  ReferenceOfShot& reference = jobContext_.inspector.reference();
  if (!needsReference(row)) return false;
  if (isOverTime(row))
    return subscriptions_.samplesOverTimeOf(overTime(row), lane) >= 0 && !reference.has(row, lane);
  return reference.samples(lane) < subscriptions_.referenceSamples;
}

void ShownWorst::deliver() {
  if (subscriptions_.worst && subscriptions_.worst->lane < jobContext_.inspector.shot().laneCount() &&
      isUnderWay())
    return;
  const std::optional<request::FindWorst> subscriptions = std::exchange(subscriptions_.worst, {});
  const InspectedShot& shot = jobContext_.inspector.shot();
  if (!subscriptions || subscriptions->lane >= shot.laneCount()) return;
  std::optional<glm::ivec2> after = subscriptions->after;
  if (after && (after->x >= shot.width() || after->y >= shot.height())) after.reset(); // of a larger picture
  jobContext_.attempt(RequestKind::Worst, [&] {
    jobContext_.tell(RequestKind::Worst,
                     WorstDelivery{shot.frame(),
                                   jobContext_.inspector.worst().next(subscriptions->row, subscriptions->lane,
                                                                      after, subscriptions->step)});
  });
}

} // namespace taa
