// The middle of some numbers.
#pragma once

#include <algorithm>
#include <vector>

namespace taa {

/// The middle one; the mean of the two middle ones; 0 of none.
inline double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

/// A difference from the median of so many median differences is an outlier: Tukey's biweight with its usual
/// 4.685 standard deviations, of which one is 1.48 median differences where noise is normal.
inline constexpr double kTukeyMedians = 4.685 * 1.48;

} // namespace taa
