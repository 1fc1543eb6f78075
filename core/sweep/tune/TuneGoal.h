// What settings are tuned for: metrics with weights, each relative to what it was at the start.
#pragma once

#include "core/measure/Metrics.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace taa {

/// What a goal calls the time of the resolve, which is no metric of a picture.
inline constexpr const char* kCostGoal = "cost";

/// What tuning looks for where nobody says what for.
inline constexpr const char* kDefaultGoal = "rmse=1,flicker=1";

/// What everybody sees, whatever the goal: how far pictures are off, and how much they flicker more.
inline constexpr std::array kGuardedMetrics{Metric::Rmse, Metric::Flicker};

/// What is known of some settings.
struct TuneNumbers {
  std::array<std::optional<double>, kMetrics.size()> means; ///< over the frames
  double cost = 1.0; ///< of the resolve, against that of the settings at the start (knownRatio())
};

/// A guarded metric that has become worse.
struct WorseMetric {
  Metric metric{};
  double rise = 0.0; ///< share of what it was at the start
};
/// Those that are above what they were by more than a hundredth; a start is counted as in TuneGoal::value().
/// What is not known of either is left out.
std::vector<WorseMetric> worseMetrics(const TuneNumbers& now, const TuneNumbers& start);

struct GoalTerm {
  std::optional<Metric> metric; ///< nothing: the cost
  double weight = 1.0;
};

/// Less is better. At the start it is the sum of the weights.
class TuneGoal {
 public:
  /// "flicker=2,rmse=1": ids of metrics, or kCostGoal, each once, weights above 0. Throws Error that says
  /// what is wrong, and names the metrics.
  explicit TuneGoal(const std::string& text);

  const std::vector<GoalTerm>& terms() const { return terms_; }
  std::vector<Metric> metrics() const;
  bool countsCost() const;

  /// Σ weight · now/start, of a metric that is better the higher it is weight · start/now, of the cost weight
  /// times its ratio. A start below a thousandth of the range that the metric is plotted in counts as that:
  /// what is nearly perfect already shall not be all that counts. Infinite where a metric of `now` is not
  /// known; expects those of `start`.
  double value(const TuneNumbers& now, const TuneNumbers& start) const;

  /// The first metric that is not known of `numbers`.
  std::optional<Metric> unknown(const TuneNumbers& numbers) const;

 private:
  std::vector<GoalTerm> terms_;
};

} // namespace taa
