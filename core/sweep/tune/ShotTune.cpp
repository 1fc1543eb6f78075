#include "core/sweep/tune/ShotTune.h"

#include "core/inspect/Inspector.h"
#include "core/sweep/ShotSweep.h"

#include <algorithm>
#include <exception>

namespace taa {

void tuneShot(const ShotTuneRequest& request, const TuneTold& told, const Progress& progress) {
  Inspector inspector;
  inspector.shot().setSettings(request.start);
  openShotOf(inspector, request.shot, progress);
  if (std::ranges::any_of(TuneGoal(request.tuning.goal).metrics(),
                          [](Metric metric) { return metricInfo(metric).needsReference; }))
    requireMeasurable(inspector, request.tuning.metrics.referenceSamples);
  Tuning tuning(inspector, request.tuning, progress);
  const std::exception_ptr ended = tuning.run([&] { told(tuning.way()); });
  if (tuning.hasStart()) told(tuning.way());
  if (ended) std::rethrow_exception(ended);
}

} // namespace taa
