// The middle of some numbers, and other ranks among them.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

namespace taa {

/// The value at `rank`, counted from 0 at the smallest; the order of the values changes. Expects numbers, and
/// more than `rank` of them.
template <typename Value>
Value valueOfRank(std::vector<Value>& values, std::size_t rank) {
  assert(rank < values.size());
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// The middle one; the mean of the two middle ones; 0 of none.
inline double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const std::size_t rank = values.size() / 2;
  const double upper = valueOfRank(values, rank);
  if (values.size() % 2 == 1) return upper;
  return 0.5 *
         (upper + *std::max_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rank)));
}

/// The middle one, the upper of the two middle ones: a value that is there. Expects at least one.
inline double upperMedian(std::vector<double> values) {
  return valueOfRank(values, values.size() / 2);
}

/// The smallest of the values that at least `percent` of them do not exceed: a value that is there (nearest
/// rank). Expects finite numbers, at least one, and 0 < percent ≤ 100; their order changes.
inline float percentile(std::vector<float>& values, int percent) {
  assert(percent > 0 && percent <= 100);
  return valueOfRank(values, (values.size() * static_cast<std::size_t>(percent) + 99) / 100 - 1);
}

/// A difference from the median of so many median differences is an outlier: Tukey's biweight with its usual
/// 4.685 standard deviations, of which one is 1.48 median differences where noise is normal.
inline constexpr double kTukeyMedians = 4.685 * 1.48;
/// Tukey's biweight: 1 at 0, 0 from `outlier` on.
inline double tukeyWeight(double difference, double outlier) {
  const double share = difference / outlier;
  return std::abs(share) >= 1.0 ? 0.0 : (1.0 - share * share) * (1.0 - share * share);
}

} // namespace taa
