#include "core/capture/import/MotionLength.h"

#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/capture/import/Comparison.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <utility>

namespace taa::capture {

namespace {

constexpr double kOctaveStep = 0.125;

/// What a factor of 2 to the power of `octaves` leaves.
using LeftBy = std::function<double(double octaves)>;

/// Where least is left, to a thousandth of an octave, where there is one least within a step of `around`.
double refinedOctaves(const LeftBy& left, double around) {
  constexpr double kNarrow = 1e-3, kGolden = 0.6180339887;
  double low = around - kOctaveStep, high = around + kOctaveStep;
  while (high - low > kNarrow) {
    const double below = high - kGolden * (high - low), above = low + kGolden * (high - low);
    if (left(below) <= left(above))
      high = above;
    else
      low = below;
  }
  return 0.5 * (low + high);
}

/// The power of 2 near 0 by which least is left: from below ½ to above 2. Infinite where ever less is left
/// towards an end: a sign that is wrong has no length.
double bestOctaves(const LeftBy& left) {
  constexpr double kFarthest = 1.25;
  double least = std::numeric_limits<double>::infinity(), around = 0.0;
  for (double octaves = -kFarthest; octaves <= kFarthest; octaves += kOctaveStep)
    if (const double residual = left(octaves); residual < least) {
      least = residual;
      around = octaves;
    }
  if (std::abs(around) == kFarthest) return std::numeric_limits<double>::infinity();
  return refinedOctaves(left, around);
}

TestState timesLengths(TestState state, const glm::dvec2& factors) {
  state.conventions.motion.scale *= factors;
  return state;
}

/// Of the factor along an axis, from how it differs from pair to pair, and from what reading between pixels
/// pulls in all of them alike.
double errorOf(FrameSamples& samples, const TestState& state, const glm::dvec2& axis) {
  const std::span<const FramePair> pairs = samples.pairs();
  if (pairs.size() < 2) return std::numeric_limits<double>::infinity();
  double sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double octaves = refinedOctaves(
        [&](double tried) {
          return roughResidual(samples, pairs.subspan(i, 1), timesLengths(state, glm::exp2(axis * tried)));
        },
        0.0);
    const double factor = std::exp2(octaves);
    sum += factor;
    squares += factor * factor;
  }
  const auto count = static_cast<double>(pairs.size());
  const double variance = std::max(0.0, squares / count - sum * sum / (count * count));
  return std::hypot(std::sqrt(variance / (count - 1.0)), kReadingError);
}

/// The decimal with the fewest digits between two numbers, of these the one nearest to their middle.
double shortestBetween(double low, double high) {
  const double middle = 0.5 * (low + high);
  if (!(high > low) || low <= 0.0) return middle;
  double step = std::pow(10.0, std::ceil(std::log10(high)));
  for (;; step /= 10.0) {
    // Of a step 0.1 is no number, and 1 / 10 is.
    const double nearest =
        step < 1.0 ? std::round(middle / step) / std::round(1.0 / step) : std::round(middle / step) * step;
    if (nearest >= low && nearest <= high) return nearest;
  }
}

} // namespace

glm::dvec2 MotionLength::rounded() const {
  constexpr double kWithinErrors = 2.0;
  const glm::dvec2 size = glm::abs(scale), sign = glm::sign(scale);
  const glm::dvec2 low = size - kWithinErrors * error, high = size + kWithinErrors * error;
  const double least = std::max(low.x, low.y), most = std::min(high.x, high.y);
  if (least < most) return sign * shortestBetween(least, most);
  return sign * glm::dvec2(shortestBetween(low.x, high.x), shortestBetween(low.y, high.y));
}

std::string MotionLength::text() const {
  const glm::dvec2 shown = rounded();
  const auto measured = [&](int axis) {
    return say<"%1 ± %2">(measuredNumber(scale[axis], error[axis]), errorNumber(error[axis]));
  };
  if (std::abs(shown.x) == std::abs(shown.y))
    return say<"Times %1: %2 and %3 as measured">(shortestText(shown.x), measured(0), measured(1));
  return say<"Times %1 and %2: %3 and %4 as measured">(shortestText(shown.x), shortestText(shown.y),
                                                       measured(0), measured(1));
}

TestState timesLength(TestState state, double factor) {
  return timesLengths(std::move(state), glm::dvec2(factor));
}

bool isOneLength(FrameSamples& samples, const TestState& state) {
  constexpr double kSameOctaves = 0.06;
  const std::span<const FramePair> pairs = samples.pairs();
  if (pairs.size() < 2) return true;
  const auto lengthOf = [&](std::span<const FramePair> some) {
    return bestOctaves(
        [&](double octaves) { return roughResidual(samples, some, timesLength(state, std::exp2(octaves))); });
  };
  const std::size_t half = pairs.size() / 2;
  return std::abs(lengthOf(pairs.first(half)) - lengthOf(pairs.last(half))) <= kSameOctaves;
}

std::optional<MotionLength> measuredLength(FrameSamples& samples, const TestState& state) {
  glm::dvec2 factor(1.0);
  const auto lengthen = [&](const glm::dvec2& axes) {
    const double octaves = bestOctaves([&](double tried) {
      return roughResidual(samples, timesLengths(state, factor * glm::exp2(axes * tried)));
    });
    factor *= glm::exp2(axes * octaves);
    return std::isfinite(octaves);
  };
  if (!lengthen({1.0, 1.0})) return {};
  for (int round = 0; round < 2; ++round)
    if (!lengthen({1.0, 0.0}) || !lengthen({0.0, 1.0})) return {};
  const TestState best = timesLengths(state, factor);
  const glm::dvec2 scale = best.conventions.motion.scale;
  return MotionLength{scale, glm::abs(scale) * glm::dvec2(errorOf(samples, best, {1.0, 0.0}),
                                                          errorOf(samples, best, {0.0, 1.0}))};
}

} // namespace taa::capture
