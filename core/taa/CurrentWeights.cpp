// The weights of the current filter: kernels of the distance between a pixel's center and where its samples
// lie.
#include "core/taa/TaaPass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace taa {

namespace {

/// The cubic of Mitchell and Netravali (1988) at distance r px, support 2.
double cubic(double r, double b, double c) {
  const double r2 = r * r, r3 = r2 * r;
  if (r < 1.0)
    return ((12.0 - 9.0 * b - 6.0 * c) * r3 + (12.0 * b + 6.0 * c - 18.0) * r2 + 6.0 - 2.0 * b) / 6.0;
  if (r >= 2.0) return 0.0;
  return ((-b - 6.0 * c) * r3 + (6.0 * b + 30.0 * c) * r2 + (-12.0 * b - 48.0 * c) * r + 8.0 * b + 24.0 * c) /
         6.0;
}

double gaussianKernel(double squaredDistance, double variance) {
  return std::exp(-squaredDistance / (2.0 * variance));
}

double mitchellKernel(double r) {
  return cubic(r, 1.0 / 3.0, 1.0 / 3.0);
}

double catmullRomKernel(double r) {
  return cubic(r, 0.0, 0.5);
}

/// The four-term window of Harris (1978), 3 px wide.
double blackmanHarrisKernel(double r) {
  if (r >= 1.5) return 0.0;
  const double angle = 2.0 * std::numbers::pi * (r / 3.0 + 0.5);
  return 0.35875 - 0.48829 * std::cos(angle) + 0.14128 * std::cos(2.0 * angle) -
         0.01168 * std::cos(3.0 * angle);
}

/// The same window as Raptor's program reads it: its argument 1 − x is twice the distance too, so that it
/// does not end at its support and comes back to 1 at distance 1 (manual §26, D3).
double blackmanHarrisAsPrinted(double place) {
  const double angle = std::numbers::pi * (1.0 - 2.0 * place);
  return 0.35875 - 0.48829 * std::cos(angle) + 0.14128 * std::cos(2.0 * angle) -
         0.01168 * std::cos(3.0 * angle);
}

/// The polynomial of FSR2 and Filament near Lanczos 2, of each axis (manual 6.7).
double lanczosKernel(double dx, double dy) {
  const auto ofAxis = [](double x) {
    const double x2 = std::min(x * x, 4.0);
    return (x2 - 1.0) * std::pow(x2 - 4.0, 3.0) / 64.0;
  };
  return ofAxis(dx) * ofAxis(dy);
}

// Of the distance from the pixel, whatever the jitter

double tentKernel(double place) {
  return place == 0.0 ? 4.0 : (place > 1.0 ? 1.0 : 2.0);
}

double boxKernel() {
  return 1.0;
}

/// Raptor's weight is the distance itself (manual §26, D2).
double distanceAsPrinted(double place) {
  return place;
}

/// Of twice the distance, as Raptor's program reads it (manual §26, D3).
double mitchellAsPrinted(double place) {
  return mitchellKernel(2.0 * place);
}

double weight(const CurrentSettings& settings, double column, double row, glm::dvec2 jitterPx) {
  const double dx = column - jitterPx.x, dy = row - jitterPx.y;
  const double distance = std::sqrt(dx * dx + dy * dy);
  const double ofPlace = std::sqrt(column * column + row * row); // whatever the jitter
  switch (settings.filter) {
  case CurrentFilter::Gaussian:
    return gaussianKernel(dx * dx + dy * dy, static_cast<double>(settings.variance));
  case CurrentFilter::Mitchell:
    return mitchellKernel(distance);
  case CurrentFilter::CatmullRom:
    return catmullRomKernel(distance);
  case CurrentFilter::BlackmanHarris:
    return blackmanHarrisKernel(distance);
  case CurrentFilter::Lanczos:
    return lanczosKernel(dx, dy);
  case CurrentFilter::Tent:
    return tentKernel(ofPlace);
  case CurrentFilter::Box:
    return boxKernel();
  case CurrentFilter::DistanceAsPrinted:
    return distanceAsPrinted(ofPlace);
  case CurrentFilter::MitchellAsPrinted:
    return mitchellAsPrinted(ofPlace);
  case CurrentFilter::BlackmanHarrisAsPrinted:
    return blackmanHarrisAsPrinted(ofPlace);
  case CurrentFilter::Center: // these three have no kernel
  case CurrentFilter::Unjitter:
  case CurrentFilter::UnjitterAsPrinted:
    break;
  }
  return 1.0;
}

} // namespace

std::array<float, 9> currentFilterWeights(const CurrentSettings& settings, glm::vec2 jitterPx) {
  constexpr std::array<float, 9> kCenter{0.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 0.0f};
  const bool isOneTap = settings.filter == CurrentFilter::Center ||
                        settings.filter == CurrentFilter::Unjitter ||
                        settings.filter == CurrentFilter::UnjitterAsPrinted;
  if (isOneTap) return kCenter;
  // The pixel's own scene sample lies at −jitter from its center, so a neighbor's lies at offset − jitter.
  const glm::dvec2 shift = settings.jitterAware == Switch::On ? glm::dvec2(jitterPx) : glm::dvec2(0.0);
  std::array<float, 9> weights{};
  float sum = 0.0f;
  for (int k = 0; k < 9; ++k) {
    weights[k] = static_cast<float>(weight(settings, k % 3 - 1, k / 3 - 1, shift));
    sum += weights[k];
  }
  return std::abs(sum) > 1e-4f ? weights : kCenter;
}

} // namespace taa
