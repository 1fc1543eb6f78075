// 16-bit floats, five bits of exponent with bias 15 (IEEE 754 binary16): their bits, and the rounding that a
// value goes through when it is stored in one.
#pragma once

#include <bit>
#include <cstdint>
#include <span>

namespace taa {

/// The value of a half float's bits without its sign: exponent in bits 10 to 14.
inline std::uint32_t floatBitsOfMagnitude(std::int32_t magnitude) {
  constexpr std::uint32_t kRebias = (127u - 15u) << 23u;
  constexpr std::int32_t kSmallestNormal = 0x400, kInfinity = 0x7c00;
  constexpr float kSubnormalStep = 5.9604644775390625e-8f; // 2⁻²⁴
  const std::uint32_t normal = (static_cast<std::uint32_t>(magnitude) << 13u) + kRebias;
  const auto subnormal = std::bit_cast<std::uint32_t>(static_cast<float>(magnitude) * kSubnormalStep);
  // Masks of all bits or none: the compiler takes ?: for branches here.
  const std::uint32_t isSubnormal = 0u - static_cast<std::uint32_t>(magnitude < kSmallestNormal);
  const std::uint32_t isInfinite = 0u - static_cast<std::uint32_t>(magnitude >= kInfinity);
  return ((subnormal & isSubnormal) | (normal & ~isSubnormal)) + (isInfinite & kRebias);
}

/// The value of a half float's bits. Without branches, so that the compiler makes loops over it vectors.
inline float floatOfHalf(std::uint16_t half) {
  const std::uint32_t sign = (half & 0x8000u) << 16u;
  return std::bit_cast<float>(sign | floatBitsOfMagnitude(half & 0x7fff));
}

/// The bits of the nearest half float, ties to even: those of packHalf2x16(). 65520 and above become
/// infinite, NaN 0x7e00 with its sign.
std::uint16_t halfOf(float value);
/// halfOf() each value. As many `halves` as `values`.
void toHalves(std::span<const float> values, std::span<std::uint16_t> halves);

/// The value of halfOf(): what unpackHalf2x16(packHalf2x16(v)) gives. NaN stays as it is.
float roundedToHalf(float value);

} // namespace taa
