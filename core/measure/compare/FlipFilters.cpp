#include "core/measure/compare/FlipFilters.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace taa {

namespace {

/// a √(π/b) exp(−π² d² / b) at d degrees: the contrast sensitivity of a channel, as a filter (table 1).
struct Sensitivity {
  double a, b;
};
constexpr Sensitivity kAchromatic{1.0, 0.0047}, kRedGreen{1.0, 0.0053}, kBlueYellow{34.1, 0.04},
    kBlueYellowTail{13.5, 0.025};
constexpr double kFeatureDegrees = 0.082; ///< from peak to trough of the eye's detector of edges

/// The part exp(…) along one axis, from −radius to radius.
std::vector<double> gaussian(const Sensitivity& sensitivity, int radius, double pixelsPerDegree) {
  std::vector<double> values;
  for (int x = -radius; x <= radius; ++x) {
    const double degrees = x / pixelsPerDegree;
    values.push_back(std::exp(-std::numbers::pi * std::numbers::pi * degrees * degrees / sensitivity.b));
  }
  return values;
}

double sumOfWeights(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum;
}

/// Times `scale`, without the ends that are nothing to a float.
FilterWeights scaledWeights(const std::vector<double>& values, double scale) {
  constexpr double kNegligible = 1e-10; // of the middle; a float has 24 bits, 6e-8
  const auto first = static_cast<std::ptrdiff_t>(
      std::ranges::find_if(values, [](double value) { return std::abs(value) > kNegligible; }) -
      values.begin());
  FilterWeights weights;
  for (auto at = values.begin() + first; at != values.end() - first; ++at)
    weights.push_back(static_cast<float>(*at * scale));
  return weights;
}

FilterWeights normalized(const std::vector<double>& values) {
  return scaledWeights(values, 1.0 / sumOfWeights(values));
}

/// What is above 0 to the sum 1, what is below to −1.
FilterWeights balanced(std::vector<double> values) {
  double above = 0.0, below = 0.0;
  for (const double value : values) (value > 0.0 ? above : below) += std::abs(value);
  for (double& value : values) value /= value > 0.0 ? above : below;
  return scaledWeights(values, 1.0);
}

} // namespace

FlipFilters::FlipFilters(double pixelsPerDegree) {
  assert(pixelsPerDegree > 0.0);
  // Three standard deviations of the widest, for all channels.
  const double deviation = std::sqrt(kBlueYellow.b / (2.0 * std::numbers::pi * std::numbers::pi));
  const auto reach = static_cast<int>(std::ceil(3.0 * deviation * pixelsPerDegree));
  achromatic = normalized(gaussian(kAchromatic, reach, pixelsPerDegree));
  redGreen = normalized(gaussian(kRedGreen, reach, pixelsPerDegree));
  const std::vector<double> wide = gaussian(kBlueYellow, reach, pixelsPerDegree);
  const std::vector<double> tail = gaussian(kBlueYellowTail, reach, pixelsPerDegree);
  const double ofWide = kBlueYellow.a * std::sqrt(std::numbers::pi / kBlueYellow.b);
  const double ofTail = kBlueYellowTail.a * std::sqrt(std::numbers::pi / kBlueYellowTail.b);
  const double sum =
      ofWide * sumOfWeights(wide) * sumOfWeights(wide) + ofTail * sumOfWeights(tail) * sumOfWeights(tail);
  blueYellow = scaledWeights(wide, std::sqrt(ofWide / sum));
  blueYellowTail = scaledWeights(tail, std::sqrt(ofTail / sum));

  const double sigma = 0.5 * kFeatureDegrees * pixelsPerDegree;
  const auto featureReach = static_cast<int>(std::ceil(3.0 * sigma));
  std::vector<double> bell, first, second;
  for (int x = -featureReach; x <= featureReach; ++x) {
    bell.push_back(std::exp(-x * x / (2.0 * sigma * sigma)));
    first.push_back(-x * bell.back());
    second.push_back((x * x / (sigma * sigma) - 1.0) * bell.back());
  }
  smooth = normalized(bell);
  edge = balanced(first);
  point = balanced(second);
  radius = std::max(reach, featureReach);
}

} // namespace taa
