#include "core/jobs/idle/StageCosting.h"

#include "core/base/Error.h"

#include <string>
#include <string_view>
#include <utility>

namespace taa {

void StageCosting::take(const request::Cancel&) {
  if (std::exchange(isMeasuring_, false)) jobContext_.endWork();
}

// Any request is answered between two draws; then it goes on, or starts anew where the frame is another one.
void StageCosting::step() {
  bool goesOn = false;
  jobContext_.attempt(RequestKind::Profile, [&] {
    try {
      StageCosts costs =
          jobContext_.inspector.profiler().measureStages([this](std::string_view what, int done, int total) {
            if (total > 1) jobContext_.tellWork(WorkKind::Stages, std::string(what), done, total);
            return !jobContext_.waiting().any();
          });
      jobContext_.tell(RequestKind::Profile, std::move(costs));
    } catch (const Cancelled&) {
      goesOn = true;
    }
  });
  isMeasuring_ = goesOn;
  if (!goesOn) jobContext_.endWork();
}

void StageCosting::deliver() {
  jobContext_.attempt(RequestKind::Profile, [&] {
    if (auto profile = jobContext_.inspector.profiler().takeProfile())
      jobContext_.tell(RequestKind::Profile, std::move(*profile));
  });
}

} // namespace taa
