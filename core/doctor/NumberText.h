// Measured numbers in sentences: as many digits as they are good for.
#pragma once

#include <glm/vec2.hpp>

#include <string>

namespace taa::doctor {

/// Three significant digits, and not more than four after the point: "0.25", "13.2", "1280".
std::string shortNumber(double value);
/// A standard error with two significant digits, "0.41"; a number with the last digit that its error leaves,
/// "319.87".
std::string errorNumber(double error);
std::string measuredNumber(double value, double error);
/// "(0.25, -0.167)"
std::string shortVector(const glm::dvec2& value);

} // namespace taa::doctor
