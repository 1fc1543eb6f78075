#include "core/doctor/motion/BroadestTrial.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>

namespace taa::doctor {

std::size_t broadestTrial(const std::vector<FittingTrial>& fitting) {
  assert(!fitting.empty());
  constexpr double kAsMuch = 0.99;
  struct Sum {
    double pixels = 0.0, gain = 0.0;
  };
  std::map<std::size_t, Sum> sums; // by trial
  for (const FittingTrial& each : fitting) {
    sums[each.trial].pixels += each.pixels;
    sums[each.trial].gain += each.gain;
  }
  double most = 0.0, gain = std::numeric_limits<double>::lowest();
  for (const auto& [trial, sum] : sums) most = std::max(most, sum.pixels);
  for (const auto& [trial, sum] : sums)
    if (sum.pixels == most) gain = std::max(gain, sum.gain);
  const double least = gain - (1.0 - kAsMuch) * std::abs(gain);
  return std::ranges::find_if(
             sums,
             [&](const auto& entry) { return entry.second.pixels == most && entry.second.gain >= least; })
      ->first;
}

} // namespace taa::doctor
