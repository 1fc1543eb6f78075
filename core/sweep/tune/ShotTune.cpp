#include "core/sweep/tune/ShotTune.h"

#include "core/gl/ContextLock.h"
#include "core/inspect/Inspector.h"
#include "core/inspect/OpenedShot.h"
#include "core/sweep/ShotSweep.h"

#include <algorithm>
#include <exception>

namespace taa {

void tuneShot(const ShotTuneRequest& request, const TuneTold& told, const Progress& progress) {
  gl::ContextLock lock;
  const Progress passing = lock.passing(progress);
  Inspector inspector;
  inspector.shot().setSettings(request.start);
  openShotOf(inspector, request.shot, passing);
  if (std::ranges::any_of(TuneGoal(request.tuning.goal).metrics(),
                          [](Metric metric) { return metricInfo(metric).needsReference; }))
    requireMeasurable(inspector, request.tuning.metrics.referenceSamples);
  Tuning tuning(inspector, request.tuning, passing);
  const std::exception_ptr ended = tuning.run([&] { told(tuning.way()); });
  if (tuning.hasStart()) told(tuning.way());
  if (ended) std::rethrow_exception(ended);
}

} // namespace taa
