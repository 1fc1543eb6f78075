// Floats of 16, 11 and 10 bits as they lie in planes: five bits of exponent with bias 15 each (IEEE 754
// binary16; Direct3D 11.3, 3.1.3). Without branches, so that the compiler makes loops over them vectors.
#pragma once

#include <bit>
#include <cstdint>

namespace taa::capture {

/// The value of a half float's bits without its sign: exponent in bits 10 to 14. Floats of 11 and 10 bits
/// are such bits, shifted left by 4 and 5.
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

inline float floatOfHalf(std::uint16_t half) {
  const std::uint32_t sign = (half & 0x8000u) << 16u;
  return std::bit_cast<float>(sign | floatBitsOfMagnitude(half & 0x7fff));
}
/// The lower 11 bits: 5 of exponent, 6 of fraction, no sign.
inline float floatOf11Bits(std::uint32_t bits) {
  return std::bit_cast<float>(floatBitsOfMagnitude(static_cast<std::int32_t>((bits & 0x7ffu) << 4u)));
}
/// The lower 10 bits: 5 of exponent, 5 of fraction, no sign.
inline float floatOf10Bits(std::uint32_t bits) {
  return std::bit_cast<float>(floatBitsOfMagnitude(static_cast<std::int32_t>((bits & 0x3ffu) << 5u)));
}

/// The nearest half, ties to even; 65520 and above become infinite, NaN stays NaN.
std::uint16_t halfOf(float value);
/// The nearest float of 5 bits of exponent and `fractionBits` of fraction without a sign, ties to even. As
/// Direct3D has it: what is negative becomes 0, what is too large the largest there is, infinity and NaN
/// stay.
std::uint32_t unsignedFloatOf(float value, int fractionBits);

} // namespace taa::capture
