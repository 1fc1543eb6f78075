#include "core/jobs/shown/ShownWorst.h"

#include "core/inspect/WorstOfShot.h"

#include <optional>
#include <utility>

namespace taa {

// Somebody makes the row, or draws the reference that it is made of, for as long as it is wanted.
bool ShownWorst::isUnderWay() const {
  const int lane = wanted_.worst->lane;
  const IntermediateId row = WorstOfShot::rowOf(wanted_.worst->row, wanted_.worst->step);
  ReferenceOfShot& reference = desk_.inspector.reference();
  if (!needsReference(row)) return false;
  if (isOverTime(row))
    return wanted_.samplesOverTimeOf(overTime(row), lane) >= 0 && !reference.has(row, lane);
  return reference.samples(lane) < wanted_.referenceSamples;
}

void ShownWorst::deliver() {
  if (wanted_.worst && wanted_.worst->lane < desk_.inspector.shot().laneCount() && isUnderWay()) return;
  const std::optional<request::FindWorst> wanted = std::exchange(wanted_.worst, {});
  const InspectedShot& shot = desk_.inspector.shot();
  if (!wanted || wanted->lane >= shot.laneCount()) return;
  std::optional<glm::ivec2> after = wanted->after;
  if (after && (after->x >= shot.width() || after->y >= shot.height())) after.reset(); // of a larger picture
  desk_.attempt(RequestKind::Worst, [&] {
    desk_.tell(RequestKind::Worst,
               WorstDelivery{shot.frame(),
                             desk_.inspector.worst().next(wanted->row, wanted->lane, after, wanted->step)});
  });
}

} // namespace taa
