// Floats of 11 and 10 bits as they lie in planes: the bits of half floats without the sign and the last 4 or
// 5 of the fraction (Direct3D 11.3, 3.1.3).
#pragma once

#include "core/base/Half.h"

#include <bit>
#include <cstdint>

namespace taa::capture {

/// The lower 11 bits: 5 of exponent, 6 of fraction, no sign.
inline float floatOf11Bits(std::uint32_t bits) {
  return std::bit_cast<float>(floatBitsOfMagnitude(static_cast<std::int32_t>((bits & 0x7ffu) << 4u)));
}
/// The lower 10 bits: 5 of exponent, 5 of fraction, no sign.
inline float floatOf10Bits(std::uint32_t bits) {
  return std::bit_cast<float>(floatBitsOfMagnitude(static_cast<std::int32_t>((bits & 0x3ffu) << 5u)));
}

/// The nearest float of 5 bits of exponent and `fractionBits` of fraction without a sign, ties to even. As
/// Direct3D has it: what is negative becomes 0, what is too large the largest there is, infinity and NaN
/// stay.
std::uint32_t unsignedFloatOf(float value, int fractionBits);

} // namespace taa::capture
