#include "core/sweep/tune/Tuning.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/inspect/Inspector.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <limits>
#include <string_view>
#include <utility>

namespace taa {

Tuning::Tuning(Inspector& inspector, const TuneRequest& request, const Progress& progress)
    : request_(request), progress_(progress), goal_(request.goal), shot_(inspector, goal_, request.metrics),
      search_(inspector.shot().settings(), tunableRows(request.varied), request.seed,
              [this](const Settings& settings) { return goalOf(settings); }) {}

std::exception_ptr Tuning::run(const std::function<void()>& evaluated) {
  evaluated_ = evaluated;
  began_ = std::chrono::steady_clock::now();
  TuneLimits limits{request_.evaluations, {}};
  if (request_.seconds > 0)
    limits = {std::numeric_limits<int>::max(), [this] { return secondsSoFar() >= request_.seconds; }};
  try {
    search_.run(limits);
  } catch (const Cancelled&) {
    return std::current_exception();
  }
  return {};
}

const TuneNumbers& Tuning::best() const {
  const std::vector<TuneStep>& steps = result().steps;
  return steps.empty() ? start() : measured_.at(static_cast<std::size_t>(steps.back().evaluation) - 1);
}

// What was made of an evaluation is known when the next one begins.
double Tuning::goalOf(const Settings& settings) {
  if (hasStart() && evaluated_) evaluated_();
  const Progress inside = [this](std::string_view, int, int) { return tell(); };
  TuneNumbers numbers = shot_.measure(settings, inside);
  if (const auto unknown = goal_.unknown(numbers); unknown && !hasStart())
    throw Error(
        say<"the metric %1 is not known of any of these frames: take more of them">(metricInfo(*unknown).id));
  measured_.push_back(std::move(numbers));
  const bool isRefused = !request_.trades && !worseMetrics(measured_.back(), start()).empty();
  return isRefused ? std::numeric_limits<double>::infinity() : goal_.value(measured_.back(), start());
}

int Tuning::secondsSoFar() const {
  const auto passed = std::chrono::steady_clock::now() - began_;
  return static_cast<int>(std::chrono::duration_cast<std::chrono::seconds>(passed).count());
}

bool Tuning::tell() const {
  if (!progress_) return true;
  const bool isTimed = request_.seconds > 0;
  const int measured = result().evaluations;
  const int done = isTimed ? std::min(secondsSoFar(), request_.seconds) : measured;
  const int total = isTimed ? request_.seconds : request_.evaluations;
  if (!hasStart())
    return progress_(isTimed ? say<"Tuning; seconds">() : say<"Tuning; settings measured">(), done, total);
  const std::string goal = shortMetricText(result().goal);
  return progress_(isTimed ? say<"Tuning, goal %1 now, %2 settings measured; seconds">(goal, measured)
                           : say<"Tuning, goal %1 now; settings measured">(goal),
                   done, total);
}

std::string termName(const GoalTerm& term) {
  return term.metric ? metricHeading(*term.metric) : std::string(kCostGoal);
}

std::optional<double> termNumber(const GoalTerm& term, const TuneNumbers& numbers) {
  return term.metric ? numbers.means[static_cast<std::size_t>(*term.metric)] : numbers.cost;
}

} // namespace taa
