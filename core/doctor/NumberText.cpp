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

std::string shortVector(const glm::dvec2& value) {
  return "(" + shortNumber(value.x) + ", " + shortNumber(value.y) + ")";
}

} // namespace taa::doctor
