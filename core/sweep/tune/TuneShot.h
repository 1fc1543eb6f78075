// Measures what a goal counts of some settings, on the same frames of what is open each time.
#pragma once

#include "core/base/Progress.h"
#include "core/settings/Settings.h"
#include "core/sweep/MetricsOfFrames.h"
#include "core/sweep/tune/TuneGoal.h"

#include <map>
#include <string>

namespace taa {

class Inspector;

class TuneShot {
 public:
  /// `inspector` has one lane, with the settings at the start. Its lanes change with each measurement.
  /// Guarded metrics are measured besides what the goal counts, as far as `request` has samples for them.
  TuneShot(Inspector& inspector, const TuneGoal& goal, const MetricsRequest& request);

  /// The cost is that of the resolve's program, timed on the last frame beside the one at the start, once for
  /// each program: numbers do not change it. Throws Error, Cancelled.
  TuneNumbers measure(const Settings& settings, const Progress& progress);

 private:
  double costOf(const Settings& settings, const Progress& progress);

  Inspector& inspector_;
  const TuneGoal& goal_;
  MetricsRequest request_;
  Settings start_;
  std::map<std::string, double> costs_; ///< by program
};

} // namespace taa
