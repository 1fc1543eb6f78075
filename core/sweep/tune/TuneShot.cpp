#include "core/sweep/tune/TuneShot.h"

#include "core/inspect/Inspector.h"
#include "core/measure/PairedTimes.h"
#include "core/settings/Parameters.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace taa {

TuneShot::TuneShot(Inspector& inspector, const TuneGoal& goal, const MetricsRequest& request)
    : inspector_(inspector), goal_(goal), request_(request), start_(inspector.shot().settings()) {
  assert(inspector.shot().laneCount() == 1);
  request_.wanted = goal.metrics();
  const auto needsReference = [](Metric metric) { return metricInfo(metric).needsReference; };
  for (const Metric metric : kGuardedMetrics)
    if (std::ranges::find(request_.wanted, metric) == request_.wanted.end() &&
        (request.referenceSamples > 0 || !needsReference(metric)))
      request_.wanted.push_back(metric);
  if (std::ranges::none_of(request_.wanted, needsReference)) request_.referenceSamples = 0;
  costs_.emplace(programKey(start_), 1.0);
  keepReferences(inspector, request_);
}

TuneNumbers TuneShot::measure(const Settings& settings, const Progress& progress) {
  TuneNumbers numbers;
  inspector_.shot().setSettings(settings);
  const LaneMetrics lane = measureFrames(inspector_, request_, progress).front();
  for (const Metric metric : request_.wanted)
    numbers.means[static_cast<std::size_t>(metric)] = meanOfFrames(lane, metric);
  if (goal_.countsCost()) numbers.cost = costOf(settings, progress);
  return numbers;
}

double TuneShot::costOf(const Settings& settings, const Progress& progress) {
  const std::string program = programKey(settings);
  if (const auto known = costs_.find(program); known != costs_.end()) return known->second;
  inspector_.shot().changeLanes({settings, start_});
  inspector_.shot().refine(progress);
  const double cost = knownRatio(inspector_.profiler().measureRatio(0, 1, progress));
  inspector_.shot().changeLanes({settings});
  return costs_.emplace(program, cost).first->second;
}

} // namespace taa
