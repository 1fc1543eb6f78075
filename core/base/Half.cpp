// Rounding to half floats, by hand, so that it does not depend on a library's or a processor's mode.
#include "core/base/Half.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace taa {

float roundedToHalf(float value) {
  constexpr float kSmallestNormal = 6.103515625e-5f; // 2⁻¹⁴
  constexpr float kOverflow = 65520.0f;              // halfway between 65504 and 2¹⁶, which there is not
  const float magnitude = std::fabs(value);
  if (!(magnitude < kOverflow)) {
    return std::isnan(value) ? value : std::copysign(std::numeric_limits<float>::infinity(), value);
  }
  if (magnitude < kSmallestNormal) {
    // Floats in ½…1 are multiples of 2⁻²⁴ as subnormal halves are, so the sum rounds to one.
    const volatile float sum = magnitude + 0.5f;
    return std::copysign(sum - 0.5f, value);
  }
  // 13 of the 23 fraction bits go; half of the last place kept, less one unless it is odd, rounds to even.
  const auto bits = std::bit_cast<std::uint32_t>(value);
  const std::uint32_t rounded = bits + 0xfffu + ((bits >> 13u) & 1u);
  return std::bit_cast<float>(rounded & ~0x1fffu);
}

} // namespace taa
