#include "app/models/verdict/LineageMath.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace taa::app {

namespace {

constexpr double kCounting = 0.01; ///< of the heaviest
constexpr double kPathWeight = 1e-3;

/// The pixel and a margin around it at least.
constexpr double kReaches[] = {0.75, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0, 24.0, 32.0};

} // namespace

double footprintReach(const std::vector<FootprintSample>& samples) {
  double heaviest = 0.0, reach = 0.0;
  for (const FootprintSample& sample : samples) heaviest = std::max(heaviest, std::fabs(sample.weight));
  for (const FootprintSample& sample : samples)
    if (std::fabs(sample.weight) >= kCounting * heaviest)
      reach = std::max({reach, std::fabs(sample.offset.x), std::fabs(sample.offset.y)});
  for (const double round : kReaches)
    if (reach <= round) return round;
  return std::ceil(reach);
}

double ageShare(const Lineage& lineage, int frame) {
  const auto oldest = static_cast<double>(lineage.frames.size()) - 1.0;
  return oldest > 0.0 ? static_cast<double>(lineage.frame - frame) / oldest : 0.0;
}

Span barSpan(const Lineage& lineage) {
  Span span{0.0, 0.0};
  for (const LineageFrame& entry : lineage.frames) {
    span.low = std::min({span.low, entry.weight, entry.weight + entry.rectified});
    span.high = std::max({span.high, entry.weight, entry.weight + entry.rectified});
  }
  return span;
}

std::vector<PathPlace> pathOf(const Lineage& lineage) {
  std::vector<PathPlace> path;
  std::size_t counting = 0;
  for (const LineageFrame& entry : lineage.frames) {
    path.push_back({entry.place, entry.weight});
    if (std::fabs(entry.weight) >= kPathWeight) counting = path.size();
  }
  path.resize(counting);
  return path;
}

} // namespace taa::app
