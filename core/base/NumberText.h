// Numbers as text, with a point whatever the locale is; "inf", "nan" where they are none.
#pragma once

#include <glm/vec2.hpp>

#include <string>

namespace taa {

/// The shortest decimal that reads back as the same number of its type: "0.18431373", "1e-05".
std::string shortestText(float value);
std::string shortestText(double value);
/// The same without an exponent from 0.0001 to 1e9: "100000", not "1e+05".
std::string decimalText(double value);

/// `digits` significant ones, without zeros at the end: "0.25", "1.2e-05".
std::string significantText(double value, int digits);
/// `decimals` after the point: "0.250".
std::string fixedText(double value, int decimals);
/// `decimals` after the point at most, without zeros at the end, never −0: "0.25".
std::string roundedText(double value, int decimals);

/// In sentences: significantText() with a typographic minus, "−0.25".
std::string numberText(double value, int digits = 4);
/// Measured numbers: three significant digits, and not more than four after the point: "0.25", "13.2",
/// "1280".
std::string shortNumber(double value);
/// A standard error with two significant digits, "0.41"; a number with the last digit that its error leaves,
/// "319.87".
std::string errorNumber(double error);
std::string measuredNumber(double value, double error);
/// "(0.25, -0.167)"
std::string shortVector(const glm::dvec2& value);

} // namespace taa
