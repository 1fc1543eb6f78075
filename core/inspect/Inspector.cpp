#include "core/inspect/Inspector.h"

#include "core/inspect/FirstSize.h"

namespace taa {

Inspector::Inspector()
    : player_(firstSize(context_.driver())), profiler_(player_, gl::timingMethodFor(context_.driver())),
      overTime_(player_, references_, context_.driver()),
      reference_(player_, references_, overTime_, context_.driver()),
      views_(player_, visualizer_, reference_), probes_(player_, reference_), lineage_(player_),
      verdicts_(player_, references_, context_.driver()), worst_(views_, reference_),
      metrics_(player_, views_, reference_, overTime_, references_),
      shot_(context_.driver(), player_, visualizer_, reference_, profiler_) {}

} // namespace taa
