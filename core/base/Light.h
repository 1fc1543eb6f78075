// Numbers of light: luminance, and the curve of sRGB.
#pragma once

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>

namespace taa {

/// Of linear red, green, blue (Rec. 709), added in the order of the shaders.
template <typename T>
T luminance(const glm::vec<3, T>& linear) {
  constexpr T kRed = static_cast<T>(0.2126), kGreen = static_cast<T>(0.7152), kBlue = static_cast<T>(0.0722);
  return (kRed * linear.x + kGreen * linear.y) + kBlue * linear.z;
}

/// IEC 61966-2-1. What is below 0 goes on straight, and what is above 1 along the curve.
template <std::floating_point T>
T srgbEncoded(T linear) {
  constexpr T kStraight = static_cast<T>(0.0031308), kSlope = static_cast<T>(12.92);
  constexpr T kScale = static_cast<T>(1.055), kOffset = static_cast<T>(0.055);
  return linear <= kStraight ? kSlope * linear
                             : kScale * std::pow(linear, T(1) / static_cast<T>(2.4)) - kOffset;
}
template <std::floating_point T>
T srgbDecoded(T encoded) {
  constexpr T kStraight = static_cast<T>(0.04045), kSlope = static_cast<T>(12.92);
  constexpr T kScale = static_cast<T>(1.055), kOffset = static_cast<T>(0.055);
  return encoded <= kStraight ? encoded / kSlope
                              : std::pow((encoded + kOffset) / kScale, static_cast<T>(2.4));
}

/// What a screen of 8 bits is sent of a linear value; what is below 0, and NaN, is 0.
inline std::uint8_t srgbByte(float linear) {
  const float shown = linear > 0.0f ? std::min(linear, 1.0f) : 0.0f;
  return static_cast<std::uint8_t>(std::lround(255.0f * srgbEncoded(shown)));
}

/// What a screen is sent of a linear value, 0 to 1.
inline double shownLight(double linear) {
  return srgbEncoded(std::clamp(linear, 0.0, 1.0));
}

} // namespace taa
