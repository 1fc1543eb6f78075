#include "core/sweep/tune/TuneGoal.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/base/Text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>
#include <string_view>
#include <system_error>

namespace taa {

namespace {

constexpr double kMinShareOfRange = 1e-3;

GoalTerm goalTerm(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::string name = text.substr(0, equals);
  GoalTerm term{findMetric(name), 0.0};
  if (!term.metric && name != kCostGoal) {
    std::vector<std::string> known;
    for (const MetricInfo& info : kMetrics) known.emplace_back(info.id);
    throw Error(
        say<"there is no metric \"%1\"; there are %2 and %3">(shownText(name), joined(known), kCostGoal));
  }
  const std::string_view weight =
      equals == std::string::npos ? std::string_view() : std::string_view(text).substr(equals + 1);
  const auto [end, error] = std::from_chars(weight.data(), weight.data() + weight.size(), term.weight);
  if (error != std::errc() || end != weight.data() + weight.size() || !std::isfinite(term.weight) ||
      term.weight <= 0.0)
    throw Error(say<"cannot read \"%1\": write METRIC=WEIGHT with a weight above 0, for example "
                    "flicker=2,rmse=1">(text));
  return term;
}

double atLeastFloor(Metric metric, double value) {
  const MetricInfo& info = metricInfo(metric);
  return std::max(value, kMinShareOfRange * (info.high - info.low));
}

/// 1 at the start, less where it is better.
double relative(Metric metric, double now, double start) {
  if (std::isnan(now)) return std::numeric_limits<double>::infinity();
  if (!metricInfo(metric).isHigherBetter) return now / atLeastFloor(metric, start);
  if (std::isinf(now)) return std::isinf(start) ? 1.0 : 0.0;
  return atLeastFloor(metric, start) / atLeastFloor(metric, now);
}

} // namespace

std::vector<WorseMetric> worseMetrics(const TuneNumbers& now, const TuneNumbers& start) {
  constexpr double kUnseenRise = 0.01;
  std::vector<WorseMetric> worse;
  for (const Metric metric : kGuardedMetrics) {
    const auto index = static_cast<std::size_t>(metric);
    if (!now.means[index] || !start.means[index]) continue;
    const double rise = relative(metric, *now.means[index], *start.means[index]) - 1.0;
    if (rise > kUnseenRise) worse.push_back({metric, rise});
  }
  return worse;
}

TuneGoal::TuneGoal(const std::string& text) {
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    terms_.push_back(goalTerm(part));
    if (std::ranges::count(terms_, terms_.back().metric, &GoalTerm::metric) > 1)
      throw Error(say<"\"%1\" is in the goal twice">(part.substr(0, part.find('='))));
  }
  if (terms_.empty())
    throw Error(say<"the goal is empty: write METRIC=WEIGHT, for example flicker=2,rmse=1">());
}

std::vector<Metric> TuneGoal::metrics() const {
  std::vector<Metric> metrics;
  for (const GoalTerm& term : terms_)
    if (term.metric) metrics.push_back(*term.metric);
  return metrics;
}

bool TuneGoal::countsCost() const {
  return std::ranges::any_of(terms_, [](const GoalTerm& term) { return !term.metric; });
}

double TuneGoal::value(const TuneNumbers& now, const TuneNumbers& start) const {
  double sum = 0.0;
  for (const GoalTerm& term : terms_) {
    if (!term.metric) {
      sum += term.weight * now.cost;
      continue;
    }
    const auto index = static_cast<std::size_t>(*term.metric);
    if (!now.means[index]) return std::numeric_limits<double>::infinity();
    sum += term.weight * relative(*term.metric, *now.means[index], start.means[index].value());
  }
  return sum;
}

std::optional<Metric> TuneGoal::unknown(const TuneNumbers& numbers) const {
  for (const GoalTerm& term : terms_)
    if (term.metric && !numbers.means[static_cast<std::size_t>(*term.metric)]) return term.metric;
  return {};
}

} // namespace taa
