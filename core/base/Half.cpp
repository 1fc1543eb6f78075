// Rounding to half floats, by hand, so that it does not depend on a library's or a processor's mode.
#include "core/base/Half.h"

#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
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

namespace {

/// Without branches, so that a compiler makes one instruction of several values. The steps are those of
/// roundedToHalf().
inline std::uint16_t halfBits(float value) {
  constexpr std::uint32_t kOverflow = 0x477ff000u, kSmallestNormal = 0x38800000u; // 65520, 2⁻¹⁴
  constexpr std::uint32_t kInfinite = 0x7f800000u, kOneHalf = 0x3f000000u;
  constexpr std::uint32_t kBiasDifference = (127u - 15u) << 10u;
  const auto bits = std::bit_cast<std::uint32_t>(value);
  const std::uint32_t sign = (bits >> 16u) & 0x8000u, magnitude = bits & 0x7fffffffu;
  const std::uint32_t subnormal =
      std::bit_cast<std::uint32_t>(std::bit_cast<float>(magnitude) + 0.5f) - kOneHalf;
  const std::uint32_t normal = ((magnitude + 0xfffu + ((magnitude >> 13u) & 1u)) >> 13u) - kBiasDifference;
  const std::uint32_t finite = magnitude < kSmallestNormal ? subnormal : normal;
  const std::uint32_t large = magnitude > kInfinite ? 0x7e00u : 0x7c00u;
  return static_cast<std::uint16_t>(sign | (magnitude >= kOverflow ? large : finite));
}

} // namespace

void toHalves(std::span<const float> values, std::span<std::uint16_t> halves) {
  assert(values.size() == halves.size());
  for (std::size_t index = 0; index < values.size(); ++index) halves[index] = halfBits(values[index]);
}

} // namespace taa
