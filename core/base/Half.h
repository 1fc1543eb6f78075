// 16-bit floats: the rounding that a value goes through when it is stored in one.
#pragma once

namespace taa {

/// `value` rounded to the nearest half float, ties to even (IEEE 754): what unpackHalf2x16(packHalf2x16(v))
/// gives. 65520 and above become infinite; NaN stays NaN.
float roundedToHalf(float value);

} // namespace taa
