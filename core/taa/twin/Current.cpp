// Stage 4, filter current: the color at the pixel's center from the displaced samples around it.
#include "core/taa/twin/Color.h"
#include "core/taa/twin/Stages.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace taa::twin {

namespace {

// Kernels of a sample's distance r from the pixel's center, px; dx and dy along the axes, `place` whatever
// the jitter

double gaussianKernel(double dx, double dy, double variance) {
  return std::exp(-(dx * dx + dy * dy) / (2.0 * variance));
}

double tentKernel(double place) {
  return place == 0.0 ? 4.0 : place == 1.0 ? 2.0 : 1.0;
}

double boxKernel() {
  return 1.0;
}

/// Mitchell and Netravali's family, as two polynomials.
double mitchellKernel(double r) {
  if (r < 1.0) return ((7.0 * r - 12.0) * r * r + 16.0 / 3.0) / 6.0;
  return r < 2.0 ? ((-7.0 / 3.0 * r + 12.0) * r * r - 20.0 * r + 32.0 / 3.0) / 6.0 : 0.0;
}

double catmullRomKernel(double r) {
  if (r < 1.0) return (1.5 * r - 2.5) * r * r + 1.0;
  return r < 2.0 ? (-0.5 * r + 2.5) * r * r - 4.0 * r + 2.0 : 0.0;
}

double blackmanHarrisKernel(double r) {
  if (r >= 1.5) return 0.0;
  const double x = 2.0 * std::numbers::pi * (r / 3.0 + 0.5);
  return 0.35875 - 0.48829 * std::cos(x) + 0.14128 * std::cos(2.0 * x) - 0.01168 * std::cos(3.0 * x);
}

double lanczosKernel(double dx, double dy) {
  const auto polynomial = [](double x) {
    const double x2 = x * x < 4.0 ? x * x : 4.0;
    return (x2 - 1.0) * (x2 - 4.0) * (x2 - 4.0) * (x2 - 4.0) / 64.0;
  };
  return polynomial(dx) * polynomial(dy);
}

/// D2.
double distanceAsPrinted(double place) {
  return place;
}

/// Of twice the distance (D3).
double mitchellAsPrinted(double place) {
  return mitchellKernel(2.0 * place);
}

/// The window of twice the distance, whose peak is at 0 and which repeats beyond 1 (D3).
double blackmanHarrisAsPrinted(double place) {
  const double angle = std::numbers::pi * (1.0 - 2.0 * place);
  return 0.35875 - 0.48829 * std::cos(angle) + 0.14128 * std::cos(2.0 * angle) -
         0.01168 * std::cos(3.0 * angle);
}

/// Weight of the sample at step (x, y), px, its content displaced by `shift`.
double kernelWeight(const CurrentSettings& settings, double x, double y, const glm::dvec2& shift) {
  const double dx = x - shift.x, dy = y - shift.y;
  const double r = std::sqrt(dx * dx + dy * dy), place = std::sqrt(x * x + y * y);
  switch (settings.filter) {
  case CurrentFilter::Gaussian:
    return gaussianKernel(dx, dy, settings.variance);
  case CurrentFilter::Tent:
    return tentKernel(place);
  case CurrentFilter::Box:
    return boxKernel();
  case CurrentFilter::Mitchell:
    return mitchellKernel(r);
  case CurrentFilter::CatmullRom:
    return catmullRomKernel(r);
  case CurrentFilter::BlackmanHarris:
    return blackmanHarrisKernel(r);
  case CurrentFilter::Lanczos:
    return lanczosKernel(dx, dy);
  case CurrentFilter::DistanceAsPrinted:
    return distanceAsPrinted(place);
  case CurrentFilter::MitchellAsPrinted:
    return mitchellAsPrinted(place);
  case CurrentFilter::BlackmanHarrisAsPrinted:
    return blackmanHarrisAsPrinted(place);
  case CurrentFilter::Center:
  case CurrentFilter::Unjitter:
  case CurrentFilter::UnjitterAsPrinted:
    break;
  }
  return place == 0.0 ? 1.0 : 0.0;
}

glm::vec3 interpolated(const glm::vec3& a, const glm::vec3& b, float share) {
  return a + share * (b - a);
}

glm::vec3 weightedSamples(const Inputs& inputs, const CurrentSettings& settings, const glm::ivec2& pixel,
                          WeightLuma chosen) {
  const std::array<float, 9> weights = currentWeights(settings, inputs.jitterPx);
  const glm::vec3 center = currentColor(inputs, pixel);
  float sum = 0.0f;
  glm::vec3 difference(0.0f);
  for (int k = 0; k < 9; ++k) {
    const glm::vec3 color = currentColor(inputs, pixel + glm::ivec2(k % 3 - 1, k / 3 - 1));
    float weight = weights[static_cast<std::size_t>(k)];
    if (settings.lumaWeighted == Switch::On) weight = weight / (1.0f + weightLuma(color, chosen));
    sum = sum + weight;
    if (k != 4) difference = difference + weight * (color - center);
  }
  // Differences, so that a constant stays itself.
  return std::fabs(sum) > 1e-4f ? center + difference / sum : center;
}

/// The tap where the pixel's center landed (7.1); as printed on the other side (D10).
glm::vec3 unjitteredTap(const Inputs& inputs, CurrentFilter chosen, const glm::ivec2& pixel) {
  return tapAt(inputs, pixel,
               chosen == CurrentFilter::UnjitterAsPrinted ? -inputs.jitterPx : inputs.jitterPx);
}

/// The Laplacian of the four around added (18.2): corrected f + s(f − mean₄), or as printed 5s f − s Σ₄.
glm::vec3 sharpenedCurrent(const Inputs& inputs, const CurrentSettings& settings, const glm::ivec2& pixel,
                           const glm::vec3& color) {
  const float s = settings.sharpenAmount;
  glm::vec3 sum(0.0f), difference(0.0f);
  for (const glm::ivec2& step : {glm::ivec2(0, -1), glm::ivec2(-1, 0), glm::ivec2(1, 0), glm::ivec2(0, 1)}) {
    sum = sum + currentColor(inputs, pixel + step);
    difference = difference + (currentColor(inputs, pixel + step) - color);
  }
  if (settings.sharpen == CurrentSharpen::LaplacianAsPrinted) return (5.0f * s) * color - s * sum;
  return color - s * (difference / 4.0f);
}

} // namespace

SampleRange sampleRange(const Inputs& inputs, const glm::ivec2& texel) {
  glm::vec3 low = currentColor(inputs, texel), high = low;
  for (int k = 0; k < 9; ++k) {
    const glm::vec3 sample = currentColor(inputs, texel + glm::ivec2(k % 3 - 1, k / 3 - 1));
    low = minimum(low, sample);
    high = maximum(high, sample);
  }
  return {low, high};
}

glm::vec3 boundedBySamples(const Inputs& inputs, const glm::ivec2& texel, const glm::vec3& color) {
  const SampleRange range = sampleRange(inputs, texel);
  return clamped(color, range.low, range.high);
}

std::array<float, 9> currentWeights(const CurrentSettings& settings, const glm::vec2& jitterPx) {
  // Pixel o of this frame holds what belongs to o − j of the picture at rest.
  const glm::dvec2 shift = settings.jitterAware == Switch::On ? glm::dvec2(jitterPx) : glm::dvec2(0.0);
  std::array<float, 9> weights{};
  float sum = 0.0f;
  for (int k = 0; k < 9; ++k) {
    const int column = k % 3 - 1, row = k / 3 - 1;
    const auto weight = static_cast<float>(kernelWeight(settings, column, row, shift));
    weights[static_cast<std::size_t>(k)] = weight;
    sum += weight;
  }
  if (std::fabs(sum) > 1e-4f) return weights;
  weights.fill(0.0f);
  weights[4] = 1.0f;
  return weights;
}

std::array<float, 9> gaussianWeights(float variance, const glm::vec2& jitterPx) {
  return currentWeights({.filter = CurrentFilter::Gaussian, .variance = variance}, jitterPx);
}

glm::vec3 tapAt(const Inputs& inputs, const glm::ivec2& texel, const glm::vec2& offset) {
  const glm::vec2 far(std::fabs(offset.x), std::fabs(offset.y));
  const glm::vec2 whole(std::floor(far.x), std::floor(far.y));
  const glm::vec2 f = far - whole;
  const glm::ivec2 x(offset.x < 0.0f ? -1 : 1, 0), y(0, offset.y < 0.0f ? -1 : 1);
  const glm::ivec2 from = texel + static_cast<int>(whole.x) * x + static_cast<int>(whole.y) * y;
  const glm::vec3 near = interpolated(currentColor(inputs, from), currentColor(inputs, from + x), f.x);
  const glm::vec3 beyond =
      interpolated(currentColor(inputs, from + y), currentColor(inputs, from + x + y), f.x);
  return storable(interpolated(near, beyond, f.y));
}

glm::vec3 sharpenCurrent(const Inputs& inputs, const CurrentSettings& settings, const glm::ivec2& texel,
                         const glm::vec3& color) {
  if (settings.sharpen == CurrentSharpen::None) return color;
  return storable(sharpenedCurrent(inputs, settings, texel, color));
}

glm::vec3 unsharpenedCurrent(const Inputs& inputs, const CurrentSettings& settings, const glm::ivec2& pixel,
                             WeightLuma chosen) {
  const auto weighted = [&] { return weightedSamples(inputs, settings, pixel, chosen); };
  switch (settings.filter) {
  case CurrentFilter::Center:
    break;
  case CurrentFilter::Unjitter:
  case CurrentFilter::UnjitterAsPrinted:
    return unjitteredTap(inputs, settings.filter, pixel);
  case CurrentFilter::Mitchell: // negative weights overshoot both ways
  case CurrentFilter::CatmullRom:
  case CurrentFilter::Lanczos:
    return storable(settings.dering == Switch::On ? boundedBySamples(inputs, pixel, weighted()) : weighted());
  case CurrentFilter::Gaussian:
  case CurrentFilter::Tent:
  case CurrentFilter::Box:
  case CurrentFilter::BlackmanHarris:
  case CurrentFilter::DistanceAsPrinted:
  case CurrentFilter::MitchellAsPrinted:
  case CurrentFilter::BlackmanHarrisAsPrinted:
    return storable(weighted());
  }
  return currentColor(inputs, pixel);
}

glm::vec3 filterCurrent(const Inputs& inputs, const CurrentSettings& settings, const glm::ivec2& pixel,
                        WeightLuma chosen) {
  return sharpenCurrent(inputs, settings, pixel, unsharpenedCurrent(inputs, settings, pixel, chosen));
}

glm::vec3 blurredRestart(const Inputs& inputs, const glm::ivec2& pixel) {
  const glm::vec3 center = currentColor(inputs, pixel);
  glm::vec3 sum = currentColor(inputs, pixel + glm::ivec2(-1, -1)) - center;
  for (const glm::ivec2& step : {glm::ivec2(1, -1), glm::ivec2(-1, 1), glm::ivec2(1, 1)})
    sum = sum + (currentColor(inputs, pixel + step) - center);
  return center + sum / 5.0f;
}

} // namespace taa::twin
