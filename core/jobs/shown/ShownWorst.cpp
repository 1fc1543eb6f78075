#include "core/jobs/shown/ShownWorst.h"

#include <utility>

namespace taa {

void ShownWorst::deliver() {
  const std::optional<request::FindWorst> wanted = std::exchange(wanted_, {});
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
