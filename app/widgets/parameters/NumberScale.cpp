#include "app/widgets/parameters/NumberScale.h"

#include <algorithm>
#include <cmath>

namespace taa::app {

namespace {
constexpr double kPixelsAcross = 250.0;

/// A multiple of a power of ten without the dust of 0.1 + 0.2.
double onMultiple(double value, double quantum) {
  const double count = std::round(value / quantum);
  return quantum < 1.0 ? count / std::round(1.0 / quantum) : count * quantum;
}
} // namespace

bool NumberScale::isBounded() const {
  return std::isfinite(minimum) && std::isfinite(maximum) && maximum > minimum;
}

bool NumberScale::isLogarithmic() const {
  return isBounded() && minimum > 0 && maximum / minimum >= 100;
}

double NumberScale::clamped(double value) const {
  return std::clamp(isInteger ? std::round(value) : value, minimum, maximum);
}

double NumberScale::fraction(double value) const {
  if (!isBounded()) return 0.0;
  const double f = isLogarithmic()
                       ? std::log(std::max(value, minimum) / minimum) / std::log(maximum / minimum)
                       : (value - minimum) / (maximum - minimum);
  return std::clamp(f, 0.0, 1.0);
}

double NumberScale::quantum(double value) const {
  if (isInteger) return 1.0;
  if (step > 0) return step;
  if (isBounded() && !isLogarithmic())
    return std::pow(10.0, std::floor(std::log10((maximum - minimum) / 50)));
  const double size = std::max(std::abs(value), 0.01);
  return std::pow(10.0, std::floor(std::log10(size)) - 1);
}

double NumberScale::stepped(double value, int steps) const {
  const double unit = quantum(value);
  return clamped(onMultiple(value + steps * unit, unit));
}

double NumberScale::dragged(double value, double pixels) const {
  if (isLogarithmic()) return value * std::pow(maximum / minimum, pixels / kPixelsAcross);
  if (isBounded()) return value + pixels * (maximum - minimum) / kPixelsAcross;
  return value + pixels * (step > 0 ? step / 4 : std::max(std::abs(value), 0.1) / 50);
}

double NumberScale::rounded(double value, bool fine) const {
  const double unit = quantum(value) * (fine && !isInteger ? 0.1 : 1.0);
  return clamped(onMultiple(value, unit));
}

} // namespace taa::app
