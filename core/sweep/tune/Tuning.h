// A search for better settings on what is open, with what was measured on its way.
#pragma once

#include "core/base/Progress.h"
#include "core/sweep/MetricsOfFrames.h"
#include "core/sweep/tune/TuneGoal.h"
#include "core/sweep/tune/TuneSearch.h"
#include "core/sweep/tune/TuneShot.h"

#include <chrono>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace taa {

class Inspector;

struct TuneRequest {
  std::string goal = kDefaultGoal; ///< see TuneGoal
  std::vector<std::string> varied; ///< paths or groups; empty: all of the resolve
  MetricsRequest metrics{};        ///< frames and samples; what is measured follows from the goal
  unsigned seed = 1;
  int evaluations = 200;
  int seconds = 0;     ///< instead of evaluations; 0: those count
  bool trades = false; ///< guarded metrics may become worse where the goal gains by it
};

/// How far a search has come.
struct TuneWay {
  TuneResult result;
  TuneNumbers start, best;
};

class Tuning {
 public:
  /// `inspector` has one lane, with the settings at the start; it and `progress` outlive this. Throws Error
  /// where the goal or what is varied is not known, or there is no reference for it.
  Tuning(Inspector& inspector, const TuneRequest& request, const Progress& progress);
  Tuning(const Tuning&) = delete;
  Tuning& operator=(const Tuning&) = delete;

  /// `evaluated`: after each evaluation. Returns what ended it before its time; what was found until then
  /// stays. Throws Error.
  std::exception_ptr run(const std::function<void()>& evaluated = {});

  const TuneGoal& goal() const { return goal_; }
  const TuneResult& result() const { return search_.result(); }
  /// Whether the start has been measured; the others expect it.
  bool hasStart() const { return !measured_.empty(); }
  const TuneNumbers& start() const { return measured_.front(); }
  const TuneNumbers& best() const;
  TuneWay way() const { return {result(), start(), best()}; }

 private:
  double goalOf(const Settings& settings);
  bool tell() const;
  int secondsSoFar() const;

  TuneRequest request_;
  const Progress& progress_;
  TuneGoal goal_;
  TuneShot shot_;
  std::function<void()> evaluated_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  std::vector<TuneNumbers> measured_; ///< of each evaluation, the start's first
  TuneSearch search_;
};

/// "flicker", or kCostGoal.
std::string termName(const GoalTerm& term);
std::optional<double> termNumber(const GoalTerm& term, const TuneNumbers& numbers);

} // namespace taa
