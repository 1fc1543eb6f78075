// How long one resolve takes against another: times of both in turns, so that what slows the machine down for
// longer than two draws falls out of their ratio and difference.
#pragma once

#include "core/base/Progress.h"
#include "core/gl/PassTimer.h"
#include "core/taa/History.h"

#include <array>
#include <vector>

namespace taa {

class TaaPass;
struct ResolvedFrame;

/// The median of measured values, and the range in which the true one lies with 96 % at least. That range is
/// one of order statistics: it asks nothing of how the values are spread, an outlier does not widen it.
struct Measured {
  double median = 0.0, low = 0.0, high = 0.0;
  /// How far the range reaches from the median.
  double spread() const;
};
/// Of six values at least; of fewer the range is all of the line.
Measured measured(std::vector<double> values);

/// ms that a draw of each took, in each round; as many of both.
struct PairedTimes {
  std::vector<double> own, base;
};
/// Of the rounds' own − base, ms.
Measured timeDifference(const PairedTimes& times);
/// Of the rounds' own / base.
Measured timeRatio(const PairedTimes& times);
/// The ratio as far as it is known: 1 where its range reaches 1.
double knownRatio(const Measured& ratio);

/// Keeps what it has measured when it is stopped, and goes on from there. Needs the current context for its
/// whole life.
class PairedMeter {
 public:
  static constexpr int kRounds = 15; ///< so that the range leaves out three of them at each end

  explicit PairedMeter(gl::TimingMethod method) : method_(method) {}

  /// Resolves both on the same inputs in turns. Reports before each round; throws Cancelled. Expects the same
  /// two until it has returned.
  PairedTimes measure(TaaPass& pass, const ResolvedFrame& own, const ResolvedFrame& base,
                      const Progress& progress);

 private:
  gl::TimingMethod method_;
  std::array<History, 2> targets_;
  PairedTimes times_;
  int repeats_ = 1; ///< draws a sample: a GPU is done before its clock ticks
};

} // namespace taa
