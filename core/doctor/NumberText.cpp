#include "core/doctor/NumberText.h"

#include "core/capture/format/ConventionText.h"

#include <algorithm>
#include <cmath>

namespace taa::doctor {

std::string shortNumber(double value) {
  if (value == 0.0 || !std::isfinite(value)) return capture::numberText(value == 0.0 ? 0.0 : value);
  const double digits = std::clamp(2.0 - std::floor(std::log10(std::abs(value))), 0.0, 4.0);
  const double rounded = std::round(value * std::pow(10.0, digits)) / std::pow(10.0, digits);
  return capture::numberText(rounded == 0.0 ? 0.0 : rounded); // not −0
}

namespace {

/// Digits after the point of two significant ones.
int digitsOf(double error) {
  if (!(error > 0.0) || !std::isfinite(error)) return 4;
  return std::clamp(1 - static_cast<int>(std::floor(std::log10(error))), 0, 6);
}

std::string roundedTo(double value, int digits) {
  const double rounded = std::round(value * std::pow(10.0, digits)) / std::pow(10.0, digits);
  return capture::numberText(rounded == 0.0 ? 0.0 : rounded); // not −0
}

} // namespace

std::string errorNumber(double error) {
  return roundedTo(error, digitsOf(error));
}

std::string measuredNumber(double value, double error) {
  return roundedTo(value, digitsOf(error));
}

std::string shortVector(const glm::dvec2& value) {
  return "(" + shortNumber(value.x) + ", " + shortNumber(value.y) + ")";
}

} // namespace taa::doctor
