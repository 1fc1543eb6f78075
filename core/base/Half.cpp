// Rounding to half floats, by hand, so that it does not depend on a library's or a processor's mode.
#include "core/base/Half.h"

#include <cassert>
#include <cmath>
#include <cstddef>

namespace taa {

std::uint16_t halfOf(float value) {
  constexpr std::uint32_t kOverflow = 0x477ff000u;       // 65520, halfway between 65504 and 2¹⁶
  constexpr std::uint32_t kSmallestNormal = 0x38800000u; // 2⁻¹⁴
  constexpr std::uint32_t kInfinite = 0x7f800000u, kOneHalf = 0x3f000000u;
  constexpr std::uint32_t kBiasDifference = (127u - 15u) << 10u;
  const auto bits = std::bit_cast<std::uint32_t>(value);
  const std::uint32_t sign = (bits >> 16u) & 0x8000u, magnitude = bits & 0x7fffffffu;
  // Floats in ½…1 are multiples of 2⁻²⁴ as subnormal halves are, so the sum rounds to one.
  const std::uint32_t subnormal =
      std::bit_cast<std::uint32_t>(std::bit_cast<float>(magnitude) + 0.5f) - kOneHalf;
  // 13 of the 23 fraction bits go; half of the last place kept, less one unless it is odd, rounds to even.
  const std::uint32_t normal = ((magnitude + 0xfffu + ((magnitude >> 13u) & 1u)) >> 13u) - kBiasDifference;
  const std::uint32_t finite = magnitude < kSmallestNormal ? subnormal : normal;
  const std::uint32_t large = magnitude > kInfinite ? 0x7e00u : 0x7c00u;
  return static_cast<std::uint16_t>(sign | (magnitude >= kOverflow ? large : finite));
}

void toHalves(std::span<const float> values, std::span<std::uint16_t> halves) {
  assert(values.size() == halves.size());
  for (std::size_t index = 0; index < values.size(); ++index) halves[index] = halfOf(values[index]);
}

float roundedToHalf(float value) {
  return std::isnan(value) ? value : floatOfHalf(halfOf(value));
}

} // namespace taa
