// How much longer the resolve of some settings takes than that of others: paired times, so that what slows
// the machine down for longer than two draws falls out.
#pragma once

#include "core/base/Progress.h"
#include "core/gl/PassTimer.h"

#include <span>

namespace taa {

class TaaPass;
struct ResolvedFrame;

/// The median of ratios, and the range in which the true one lies with 96 % at least.
struct CostRatio {
  double median = 1.0, low = 1.0, high = 1.0;
  /// 1 where the range reaches it: no difference is known then.
  double known() const { return low <= 1.0 && high >= 1.0 ? 1.0 : median; }
};

/// Of times of both, taken one right after the other in each round. Expects as many of each, six at least.
CostRatio costRatio(std::span<const double> times, std::span<const double> baseTimes);

/// Draws both on the same inputs in turns. Reports after each round; throws Cancelled.
CostRatio measureCostRatio(TaaPass& pass, const ResolvedFrame& frame, const ResolvedFrame& base,
                           gl::TimingMethod method, const Progress& progress);

} // namespace taa
