#include "core/base/NumberText.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <system_error>

namespace taa {

namespace {

std::string written(auto value, auto... format) {
  if (std::isnan(value)) return "nan"; // of either sign
  std::array<char, 384> text{};        // the largest number has 309 digits before its point
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value, format...);
  assert(result.ec == std::errc());
  return {text.data(), result.ptr};
}

/// Digits after the point of two significant ones.
int digitsOfError(double error) {
  if (!(error > 0.0) || !std::isfinite(error)) return 4;
  return std::clamp(1 - static_cast<int>(std::floor(std::log10(error))), 0, 6);
}

} // namespace

std::string shortestText(float value) {
  return written(value);
}

std::string shortestText(double value) {
  return written(value);
}

std::string decimalText(double value) {
  const double size = std::abs(value);
  const bool isReadable = size == 0.0 || (size >= 1e-4 && size <= 1e9);
  return isReadable ? written(value, std::chars_format::fixed) : written(value);
}

std::string significantText(double value, int digits) {
  return written(value, std::chars_format::general, digits);
}

std::string fixedText(double value, int decimals) {
  return written(value, std::chars_format::fixed, decimals);
}

std::string roundedText(double value, int decimals) {
  const double scale = std::pow(10.0, decimals), rounded = std::round(value * scale) / scale;
  return decimalText(rounded == 0.0 ? 0.0 : rounded);
}

std::string numberText(double value, int digits) {
  return (value < 0.0 ? "−" : "") + significantText(std::fabs(value), digits);
}

std::string shortNumber(double value) {
  if (value == 0.0 || !std::isfinite(value)) return decimalText(value == 0.0 ? 0.0 : value);
  return roundedText(value,
                     static_cast<int>(std::clamp(2.0 - std::floor(std::log10(std::abs(value))), 0.0, 4.0)));
}

std::string errorNumber(double error) {
  return measuredNumber(error, error);
}

std::string measuredNumber(double value, double error) {
  return roundedText(value, digitsOfError(error));
}

std::string shortVector(const glm::dvec2& value) {
  return "(" + shortNumber(value.x) + ", " + shortNumber(value.y) + ")";
}

} // namespace taa
