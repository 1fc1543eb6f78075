// A value that stands for something else in a plane, as it comes out of the formats planes are stored in.
#pragma once

#include "core/base/Half.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace taa::capture {

/// Compares what was stored with a stated value in the precision of 32 and of 16 bits, and as whole numbers
/// of 8, 16 and 24 bits hold it that stand for 0 to 1: 0.5 is 32767 or 32768 of 65535, as hardware likes.
class StoredValue {
 public:
  StoredValue() = default; ///< nothing equals it
  explicit StoredValue(const std::optional<double>& value) {
    if (!value) return;
    full_ = static_cast<float>(*value);
    half_ = roundedToHalf(full_);
    hasSteps_ = *value > 0.0 && *value < 1.0;
    for (std::size_t i = 0; hasSteps_ && i < kLargestCounts.size(); ++i) {
      steps_[2 * i] = static_cast<float>(std::floor(*value * kLargestCounts[i] + 0.5) / kLargestCounts[i]);
      steps_[2 * i + 1] = static_cast<float>(std::ceil(*value * kLargestCounts[i] - 0.5) / kLargestCounts[i]);
    }
  }
  bool operator==(float stored) const {
    return stored == full_ || stored == half_ ||
           (hasSteps_ && std::ranges::find(steps_, stored) != steps_.end());
  }
  bool isStated() const { return full_ == full_; }
  float value() const { return full_; }

 private:
  static constexpr std::array<double, 3> kLargestCounts = {255.0, 65535.0, 16777215.0};

  float full_ = std::numeric_limits<float>::quiet_NaN();
  float half_ = std::numeric_limits<float>::quiet_NaN();
  std::array<float, 2 * kLargestCounts.size()> steps_{};
  bool hasSteps_ = false; ///< between 0 and 1, which themselves are the same in all formats
};

} // namespace taa::capture
