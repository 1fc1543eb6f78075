// A value that stands for something else in a plane, as it comes out of the formats planes are stored in.
#pragma once

#include "core/base/Half.h"

#include <limits>
#include <optional>

namespace taa::capture {

/// Compares what was stored with a stated value in the precision of 32 and of 16 bits.
class StoredValue {
 public:
  StoredValue() = default; ///< nothing equals it
  explicit StoredValue(const std::optional<double>& value) {
    if (!value) return;
    full_ = static_cast<float>(*value);
    half_ = roundedToHalf(full_);
  }
  bool operator==(float stored) const { return stored == full_ || stored == half_; }
  bool isStated() const { return full_ == full_; }
  float value() const { return full_; }

 private:
  float full_ = std::numeric_limits<float>::quiet_NaN();
  float half_ = std::numeric_limits<float>::quiet_NaN();
};

} // namespace taa::capture
