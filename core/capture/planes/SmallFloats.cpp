#include "core/capture/planes/SmallFloats.h"

#include <algorithm>
#include <cmath>

namespace taa::capture {

std::uint32_t unsignedFloatOf(float value, int fractionBits) {
  const std::uint32_t infinity = 31u << static_cast<unsigned>(fractionBits);
  if (std::isnan(value)) return infinity + 1u;
  if (std::isinf(value)) return value > 0.0f ? infinity : 0u;
  if (!(value > 0.0f)) return 0u;
  const int exponent = std::max(std::ilogb(value), -14);
  // In steps of the last place, at most 2^(fractionBits + 1) of them: exact but for the rounding itself.
  const auto steps = static_cast<std::uint32_t>(
      std::nearbyint(std::ldexp(static_cast<double>(value), fractionBits - exponent)));
  // Steps of a normal number hold its leading one, which is one of the exponent.
  const std::uint64_t bits =
      (static_cast<std::uint64_t>(exponent + 14) << static_cast<unsigned>(fractionBits)) + steps;
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(bits, infinity - 1u));
}

} // namespace taa::capture
