// 16-bit floats: the rounding that a value goes through when it is stored in one.
#pragma once

#include <cstdint>
#include <span>

namespace taa {

/// `value` rounded to the nearest half float, ties to even (IEEE 754): what unpackHalf2x16(packHalf2x16(v))
/// gives. 65520 and above become infinite; NaN stays NaN.
float roundedToHalf(float value);

/// The bits of roundedToHalf() of each value, NaN as 0x7e00 with its sign. As many `halves` as `values`. Many
/// at a time.
void toHalves(std::span<const float> values, std::span<std::uint16_t> halves);

} // namespace taa
