// Whether two images agree within limits, and where they differ most.
#include "tests/support/CompareImages.h"

#include "tests/support/pictures/FailedImages.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <vector>

namespace taa::test {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool haveSameShape(const Image& a, const Image& b) {
  return a.width == b.width && a.height == b.height && a.channels == b.channels;
}

std::string shapeOf(const Image& image) {
  return std::to_string(image.width) + " x " + std::to_string(image.height) + " x " +
         std::to_string(image.channels);
}

/// How far apart two values are; infinite where only one is NaN, or they are infinite in different ways.
double distance(float actual, float expected) {
  if (std::isnan(actual) && std::isnan(expected)) return 0.0;
  if (std::isfinite(actual) && std::isfinite(expected))
    return std::abs(static_cast<double>(actual) - static_cast<double>(expected));
  return actual == expected ? 0.0 : kInfinity;
}

double scaleOf(float expected) {
  return std::isfinite(expected) ? std::max(1.0, std::abs(static_cast<double>(expected))) : 1.0;
}

bool isWithin(float actual, float expected, float tolerance) {
  if (std::isnan(actual) || std::isnan(expected)) return std::isnan(actual) && std::isnan(expected);
  if (std::bit_cast<std::uint32_t>(actual) == std::bit_cast<std::uint32_t>(expected)) return true;
  if (!std::isfinite(actual) || !std::isfinite(expected)) return false;
  return tolerance > 0.0f && std::abs(actual - expected) <= tolerance * std::max(1.0f, std::abs(expected));
}

/// The highest minus the lowest finite value, at least 1.
double reachOf(const Image& image) {
  double low = kInfinity, high = -kInfinity;
  for (const float value : image.pixels) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, static_cast<double>(value));
    high = std::max(high, static_cast<double>(value));
  }
  return std::max(1.0, high - low);
}

/// Differences of a whole image, before they are held to limits.
struct Differences {
  std::size_t differing = 0, lost = 0; ///< lost: only one of the two values is finite
  std::size_t worstIndex = 0;
  double worst = 0.0;        ///< of finite pairs, not relative
  double worstScaled = -1.0; ///< at worstIndex; infinite: a lost one
  double sum = 0.0;

  void add(std::size_t index, float actual, float expected, float tolerance) {
    const double apart = distance(actual, expected), scaled = apart / scaleOf(expected);
    const bool differs = !isWithin(actual, expected, tolerance);
    if (scaled > worstScaled || (differs && differing == 0)) {
      worstScaled = scaled;
      worstIndex = index;
    }
    differing += differs;
    if (!std::isfinite(apart)) {
      ++lost;
      return;
    }
    sum += scaled;
    if (differs) worst = std::max(worst, apart);
  }
};

Differences differencesOf(const Image& actual, const Image& expected, float tolerance) {
  Differences found;
  for (std::size_t index = 0; index < actual.pixels.size(); ++index)
    found.add(index, actual.pixels[index], expected.pixels[index], tolerance);
  return found;
}

bool isWithin(const Differences& found, double mean, const Image& expected, const Limits& limits) {
  if (mean > limits.mean || (found.lost > 0 && !limits.mayLoseFinite)) return false;
  if (found.differing == 0) return true;
  return static_cast<double>(found.differing) <=
             limits.outliers * static_cast<double>(expected.pixels.size()) &&
         found.worst <= static_cast<double>(limits.worst) * reachOf(expected);
}

void describe(Comparison& result, const Image& actual, const Image& expected, const Limits& limits,
              const Differences& found) {
  std::ostringstream text;
  text.precision(9);
  text << result.differing << " of " << actual.pixels.size() << " values differ";
  if (limits.tolerance > 0.0f) text << " by more than " << limits.tolerance;
  if (limits.outliers > 0.0)
    text << " (" << std::floor(limits.outliers * static_cast<double>(actual.pixels.size()))
         << " may, by at most " << static_cast<double>(limits.worst) * reachOf(expected) << ")";
  text << ", the worst at (" << result.x << ", " << result.y << ") channel " << result.channel << ": "
       << actual.pixels[found.worstIndex] << ", expected " << expected.pixels[found.worstIndex]
       << "; mean difference " << result.mean;
  if (std::isfinite(limits.mean)) text << " (at most " << limits.mean << ")";
  if (found.lost > 0) text << "; " << found.lost << " are NaN or infinite in one image alone";
  result.text = text.str();
}

} // namespace

Limits limitsOf(bool isExact, float tolerance) {
  if (isExact) return {};
  Limits limits;
  limits.tolerance = tolerance;
  limits.outliers = 0.01;
  limits.worst = 1.0f;
  return limits;
}

Comparison compare(const Image& actual, const Image& expected, const Limits& limits) {
  Comparison result;
  if (!haveSameShape(actual, expected)) {
    result.agrees = false;
    result.text = "sizes differ: " + shapeOf(actual) + ", expected " + shapeOf(expected);
    return result;
  }
  if (actual.pixels.empty()) return result;
  const Differences found = differencesOf(actual, expected, limits.tolerance);
  const auto pixel = static_cast<int>(found.worstIndex / static_cast<std::size_t>(actual.channels));
  result.x = pixel % actual.width;
  result.y = pixel / actual.width;
  result.channel = static_cast<int>(found.worstIndex % static_cast<std::size_t>(actual.channels));
  result.differing = found.differing;
  result.worst = distance(actual.pixels[found.worstIndex], expected.pixels[found.worstIndex]);
  const std::size_t finite = actual.pixels.size() - found.lost;
  result.mean = finite > 0 ? found.sum / static_cast<double>(finite) : 0.0;
  result.agrees = isWithin(found, result.mean, expected, limits);
  if (!result.agrees) describe(result, actual, expected, limits, found);
  return result;
}

std::string difference(const Image& actual, const Image& expected, const Limits& limits) {
  const Comparison result = compare(actual, expected, limits);
  if (result.agrees) return {};
  const std::string pictures = writeFailedImages(failedImagesOfTest(), actual, expected);
  return pictures.empty() ? result.text : result.text + "; " + pictures;
}

std::string difference(const Image& actual, const Image& expected, float tolerance) {
  Limits limits;
  limits.tolerance = tolerance;
  return difference(actual, expected, limits);
}

bool agree(const Image& actual, const Image& expected, float tolerance) {
  Limits limits;
  limits.tolerance = tolerance;
  return compare(actual, expected, limits).agrees;
}

Image crop(const Image& image, int x, int y, int width, int height) {
  Image part(width, height, image.channels);
  for (int row = 0; row < height; ++row)
    std::copy_n(image.at(x, y + row), static_cast<std::size_t>(width) * image.channels, part.at(0, row));
  return part;
}

} // namespace taa::test
