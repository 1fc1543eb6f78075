// Looks for settings that serve a goal better, one parameter at a time: a pattern search over numbers, all
// values of choices and switches.
#pragma once

#include "core/settings/Parameters.h"
#include "core/settings/Settings.h"

#include <functional>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace taa {

/// Rows of the resolve that a search may change: neither what is drawn for it, nor what is shown of it, nor
/// the format of history, whose cost in memory no goal counts.
std::vector<const Parameter*> tunableRows();
/// Those that `names` names, by their path or the group before its dot; of no names all. Throws Error.
std::vector<const Parameter*> tunableRows(const std::vector<std::string>& names);

/// What a row may be tried at, besides `value`, which it has: all that a choice or switch has; of numbers one
/// step down and one up. `step`: share of the range, of one that begins at 0 or above along its cube root, so
/// that 0.04 is as far from 0.1 as that is from 0.2. Rounded to three digits.
std::vector<double> tunedValues(const Parameter& row, double value, double step);

struct TuneStep {
  int evaluation = 0; ///< of how many, the start being the first
  double goal = 0.0;  ///< with all changes up to this one
  std::string change; ///< "rectify.method=clip"
};

struct TuneLimits {
  int evaluations = 200;
  std::function<bool()> isTimeOver; ///< empty: never
};

/// The best so far; as good as the start by its own goal at least.
struct TuneResult {
  Settings settings;
  double startGoal = 0.0, goal = 0.0;
  int evaluations = 0;
  std::vector<TuneStep> steps; ///< changes that were kept, each by itself better than all before
  bool isComplete = false;     ///< no single change of any row is better; else a limit ended it
};

class TuneSearch {
 public:
  /// The goal of some settings, less is better; throws Cancelled to end the search.
  using Evaluate = std::function<double(const Settings&)>;

  /// The order in which rows are tried depends on `seed` alone: with equal goals the way is the same.
  TuneSearch(const Settings& start, std::vector<const Parameter*> rows, unsigned seed, Evaluate evaluate);

  /// Until nothing is better or a limit is reached. What `evaluate` throws goes on; result() stays.
  void run(const TuneLimits& limits);
  const TuneResult& result() const { return result_; }

 private:
  bool goRound(double step, bool withChoices);
  bool improve(const Parameter& row, double step);
  bool tryValue(const Parameter& row, double value);
  double goalOf(const Settings& settings);
  bool isOver() const;

  Settings start_;
  std::vector<const Parameter*> rows_;
  std::mt19937 random_;
  Evaluate evaluate_;
  TuneLimits limits_;
  TuneResult result_;
  std::map<std::string, double> known_; ///< goals by the settings' differences from the start
};

} // namespace taa
