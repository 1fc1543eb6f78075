// Stage 4, filter current: the color at the pixel's center from the displaced samples around it.
#include "core/taa/twin/Color.h"
#include "core/taa/twin/Instances.h"
#include "core/taa/twin/Stages.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace taa::twin {

namespace {

// Kernels of a sample's distance r from the pixel's center, px; dx and dy along the axes, `place` whatever
// the jitter

template <typename Number>
Number gaussianKernel(Number dx, Number dy, Number variance) {
  return exp(-(dx * dx + dy * dy) / (2.0 * variance));
}

template <typename Number>
Number tentKernel(Number place) {
  return place == 0.0 ? 4.0 : place == 1.0 ? 2.0 : 1.0;
}

template <typename Number>
Number boxKernel() {
  return 1.0;
}

/// Mitchell and Netravali's family, as two polynomials.
template <typename Number>
Number mitchellKernel(Number r) {
  if (r < 1.0) return ((7.0 * r - 12.0) * r * r + 16.0 / 3.0) / 6.0;
  return r < 2.0 ? ((-7.0 / 3.0 * r + 12.0) * r * r - 20.0 * r + 32.0 / 3.0) / 6.0 : 0.0;
}

template <typename Number>
Number catmullRomKernel(Number r) {
  if (r < 1.0) return (1.5 * r - 2.5) * r * r + 1.0;
  return r < 2.0 ? (-0.5 * r + 2.5) * r * r - 4.0 * r + 2.0 : 0.0;
}

template <typename Number>
Number blackmanHarrisKernel(Number r) {
  if (r >= 1.5) return 0.0;
  const Number x = 2.0 * std::numbers::pi * (r / 3.0 + 0.5);
  return 0.35875 - 0.48829 * cos(x) + 0.14128 * cos(2.0 * x) - 0.01168 * cos(3.0 * x);
}

template <typename Number>
Number lanczosKernel(Number dx, Number dy) {
  const auto polynomial = [](Number x) {
    const Number x2 = x * x < 4.0 ? x * x : 4.0;
    return (x2 - 1.0) * (x2 - 4.0) * (x2 - 4.0) * (x2 - 4.0) / 64.0;
  };
  return polynomial(dx) * polynomial(dy);
}

/// D2.
template <typename Number>
Number distanceAsPrinted(Number place) {
  return place;
}

/// Of twice the distance (D3).
template <typename Number>
Number mitchellAsPrinted(Number place) {
  return mitchellKernel(2.0 * place);
}

/// The window of twice the distance, whose peak is at 0 and which repeats beyond 1 (D3).
template <typename Number>
Number blackmanHarrisAsPrinted(Number place) {
  const Number angle = std::numbers::pi * (1.0 - 2.0 * place);
  return 0.35875 - 0.48829 * cos(angle) + 0.14128 * cos(2.0 * angle) - 0.01168 * cos(3.0 * angle);
}

/// Weight of the sample at step (x, y), px, its content displaced by `shift`. `variance`: of the Gaussian.
template <typename Number>
Number kernelWeight(CurrentFilter filter, Number variance, Number x, Number y, const Vec2<Number>& shift) {
  const Number dx = x - shift.x, dy = y - shift.y;
  const Number r = sqrt(dx * dx + dy * dy), place = sqrt(x * x + y * y);
  switch (filter) {
  case CurrentFilter::Gaussian:
    return gaussianKernel(dx, dy, variance);
  case CurrentFilter::Tent:
    return tentKernel(place);
  case CurrentFilter::Box:
    return boxKernel<Number>();
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

template <typename Real>
Vec3<Real> interpolated(const Vec3<Real>& a, const Vec3<Real>& b, Real share) {
  return a + share * (b - a);
}

template <typename Real>
Vec3<Real> weightedSamples(const Inputs& inputs, const CurrentSettings& settings, const glm::ivec2& pixel,
                           WeightLuma chosen) {
  const std::array<Real, 9> weights = currentWeights(settings, Vec2<Real>(inputs.jitterPx));
  const Vec3<Real> center = currentColor<Real>(inputs, pixel);
  Real sum = 0.0f;
  Vec3<Real> difference(0.0f);
  for (int k = 0; k < 9; ++k) {
    const Vec3<Real> color = currentColor<Real>(inputs, pixel + glm::ivec2(k % 3 - 1, k / 3 - 1));
    Real weight = weights[static_cast<std::size_t>(k)];
    if (settings.lumaWeighted == Switch::On) weight = weight / (1.0f + weightLuma(color, chosen));
    weight = named(weight);
    sum = sum + weight;
    if (k != 4) difference = difference + weight * (color - center);
  }
  // Differences, so that a constant stays itself.
  return fabs(sum) > 1e-4f ? center + difference / sum : center;
}

/// The tap where the pixel's center landed (7.1); as printed on the other side (D10).
template <typename Real>
Vec3<Real> unjitteredTap(const Inputs& inputs, CurrentFilter chosen, const glm::ivec2& pixel) {
  const Vec2<Real> jitterPx(inputs.jitterPx);
  return tapAt(inputs, pixel, chosen == CurrentFilter::UnjitterAsPrinted ? -jitterPx : jitterPx);
}

/// The Laplacian of the four around added (18.2): corrected f + s(f − mean₄), or as printed 5s f − s Σ₄.
template <typename Real>
Vec3<Real> sharpenedCurrent(const Inputs& inputs, const CurrentSettings& settings, const glm::ivec2& pixel,
                            const Vec3<Real>& color) {
  const auto s = number<Real>(settings.sharpenAmount);
  Vec3<Real> sum(0.0f), difference(0.0f);
  for (const glm::ivec2& step : {glm::ivec2(0, -1), glm::ivec2(-1, 0), glm::ivec2(1, 0), glm::ivec2(0, 1)}) {
    sum = sum + currentColor<Real>(inputs, pixel + step);
    difference = difference + (currentColor<Real>(inputs, pixel + step) - color);
  }
  if (settings.sharpen == CurrentSharpen::LaplacianAsPrinted) return (5.0f * s) * color - s * sum;
  return color - s * (difference / 4.0f);
}

} // namespace

template <typename Real>
SampleRangeOf<Real> sampleRange(const Inputs& inputs, const glm::ivec2& texel) {
  Vec3<Real> low = currentColor<Real>(inputs, texel), high = low;
  for (int k = 0; k < 9; ++k) {
    const Vec3<Real> sample = currentColor<Real>(inputs, texel + glm::ivec2(k % 3 - 1, k / 3 - 1));
    low = minimum(low, sample);
    high = maximum(high, sample);
  }
  return {low, high};
}

template <typename Real>
Vec3<Real> boundedBySamples(const Inputs& inputs, const glm::ivec2& texel, const Vec3<Real>& color) {
  const SampleRangeOf<Real> range = sampleRange<Real>(inputs, texel);
  return clamped(color, range.low, range.high);
}

template <typename Real>
std::array<Real, 9> currentWeights(CurrentFilter filter, bool isJitterAware, Real variance,
                                   const Vec2<Real>& jitterPx) {
  // Pixel o of this frame holds what belongs to o − j of the picture at rest.
  const Vec2<Wide<Real>> shift = isJitterAware ? Vec2<Wide<Real>>(jitterPx) : Vec2<Wide<Real>>(0.0);
  std::array<Real, 9> weights{};
  Real sum = 0.0f;
  for (int k = 0; k < 9; ++k) {
    const int column = k % 3 - 1, row = k / 3 - 1;
    const auto weight = static_cast<Real>(
        kernelWeight<Wide<Real>>(filter, static_cast<Wide<Real>>(variance), column, row, shift));
    weights[static_cast<std::size_t>(k)] = weight;
    sum += weight;
  }
  if (fabs(sum) > 1e-4f) return weights;
  weights.fill(0.0f);
  weights[4] = 1.0f;
  return weights;
}

template <typename Real>
std::array<Real, 9> currentWeights(const CurrentSettings& settings, const Vec2<Real>& jitterPx) {
  return currentWeights(settings.filter, isOn(settings.jitterAware), number<Real>(settings.variance),
                        jitterPx);
}

template <typename Real>
std::array<Real, 9> gaussianWeights(Real variance, const Vec2<Real>& jitterPx) {
  return currentWeights(CurrentFilter::Gaussian, true, variance, jitterPx);
}

template <typename Real>
Vec3<Real> tapAt(const Inputs& inputs, const glm::ivec2& texel, const Vec2<Real>& offset) {
  const Vec2<Real> far(fabs(offset.x), fabs(offset.y));
  const glm::ivec2 steps(whole(far.x), whole(far.y));
  const Vec2<Real> f = far - Vec2<Real>(steps);
  const glm::ivec2 x(offset.x < 0.0f ? -1 : 1, 0), y(0, offset.y < 0.0f ? -1 : 1);
  const glm::ivec2 from = texel + steps.x * x + steps.y * y;
  const Vec3<Real> near =
      interpolated(currentColor<Real>(inputs, from), currentColor<Real>(inputs, from + x), f.x);
  const Vec3<Real> beyond =
      interpolated(currentColor<Real>(inputs, from + y), currentColor<Real>(inputs, from + x + y), f.x);
  return storable(interpolated(near, beyond, f.y));
}

template <typename Real>
Vec3<Real> sharpenCurrent(const Inputs& inputs, const CurrentSettings& settings, const glm::ivec2& texel,
                          const Vec3<Real>& color) {
  if (settings.sharpen == CurrentSharpen::None) return color;
  return storable(sharpenedCurrent(inputs, settings, texel, color));
}

namespace {

/// Before it is sharpened.
template <typename Real>
Vec3<Real> unsharpenedCurrent(const Inputs& inputs, const CurrentSettings& settings, const glm::ivec2& pixel,
                              WeightLuma chosen) {
  const auto weighted = [&] { return weightedSamples<Real>(inputs, settings, pixel, chosen); };
  switch (settings.filter) {
  case CurrentFilter::Center:
    break;
  case CurrentFilter::Unjitter:
  case CurrentFilter::UnjitterAsPrinted:
    return unjitteredTap<Real>(inputs, settings.filter, pixel);
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
  return currentColor<Real>(inputs, pixel);
}

} // namespace

template <typename Real>
Vec3<Real> filterCurrent(const Inputs& inputs, const CurrentSettings& settings, const glm::ivec2& pixel,
                         WeightLuma chosen) {
  return sharpenCurrent(inputs, settings, pixel, unsharpenedCurrent<Real>(inputs, settings, pixel, chosen));
}

template <typename Real>
Vec3<Real> blurredRestart(const Inputs& inputs, const glm::ivec2& pixel) {
  const Vec3<Real> center = currentColor<Real>(inputs, pixel);
  Vec3<Real> sum = currentColor<Real>(inputs, pixel + glm::ivec2(-1, -1)) - center;
  for (const glm::ivec2& step : {glm::ivec2(1, -1), glm::ivec2(-1, 1), glm::ivec2(1, 1)})
    sum = sum + (currentColor<Real>(inputs, pixel + step) - center);
  return center + sum / 5.0f;
}

#define TAA_CURRENT(Real)                                                                                    \
  template std::array<Real, 9> gaussianWeights(Real variance, const Vec2<Real>& jitterPx);                   \
  template std::array<Real, 9> currentWeights(const CurrentSettings& settings, const Vec2<Real>& jitterPx);  \
  template Vec3<Real> blurredRestart(const Inputs& inputs, const glm::ivec2& pixel);                         \
  template SampleRangeOf<Real> sampleRange(const Inputs& inputs, const glm::ivec2& texel);                   \
  template Vec3<Real> boundedBySamples(const Inputs& inputs, const glm::ivec2& texel,                        \
                                       const Vec3<Real>& color);                                             \
  template Vec3<Real> sharpenCurrent(const Inputs& inputs, const CurrentSettings& settings,                  \
                                     const glm::ivec2& texel, const Vec3<Real>& color);                      \
  template Vec3<Real> tapAt(const Inputs& inputs, const glm::ivec2& texel, const Vec2<Real>& offset);        \
  template Vec3<Real> filterCurrent(const Inputs& inputs, const CurrentSettings& settings,                   \
                                    const glm::ivec2& pixel, WeightLuma chosen);
TAA_EACH_NUMBER(TAA_CURRENT)
#undef TAA_CURRENT

} // namespace taa::twin
