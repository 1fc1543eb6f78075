#include "core/measure/compare/HdrFlip.h"

#include "core/base/Median.h"
#include "core/base/Say.h"
#include "core/measure/compare/Flip.h"
#include "core/taa/twin/Color.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace taa {

namespace {

// y = (a x² + b x) / (c x² + d x + e)
constexpr double kAcesA = 0.6 * 0.6 * 2.51, kAcesB = 0.6 * 0.03, kAcesC = 0.6 * 0.6 * 2.43,
                 kAcesD = 0.6 * 0.59, kAcesE = 0.14;
constexpr double kBright = 0.85; ///< where the brightest and the median pixel are put

/// What the tone mapper makes 0.85 of.
double linearOfBright() {
  const double a = kAcesA - kBright * kAcesC, b = kAcesB - kBright * kAcesD, c = -kBright * kAcesE;
  return (-b + std::sqrt(b * b - 4.0 * a * c)) / (2.0 * a);
}

std::vector<double> luminancesOf(const Image& linear) {
  std::vector<double> luminances;
  luminances.reserve(static_cast<std::size_t>(linear.width) * static_cast<std::size_t>(linear.height));
  for (int y = 0; y < linear.height; ++y)
    for (int x = 0; x < linear.width; ++x)
      luminances.push_back(std::max(0.0f, twin::luma(glm::vec3(linear.texel(x, y)))));
  return luminances;
}

Image toneMapped(const Image& linear, double exposure) {
  const auto scale = static_cast<float>(std::exp2(exposure));
  Image mapped(linear.width, linear.height, 3);
  for (int y = 0; y < linear.height; ++y)
    for (int x = 0; x < linear.width; ++x)
      for (int channel = 0; channel < 3; ++channel)
        mapped.at(x, y)[channel] = acesToneMapped(scale * linear.at(x, y)[channel]);
  return mapped;
}

} // namespace

float acesToneMapped(float linear) {
  const double x = std::max(0.0, static_cast<double>(linear));
  const double mapped = x * (kAcesA * x + kAcesB) / (x * (kAcesC * x + kAcesD) + kAcesE);
  return static_cast<float>(std::min(mapped, 1.0));
}

std::vector<double> flipExposures(const Image& reference) {
  std::vector<double> luminances = luminancesOf(reference);
  const double brightest = luminances.empty() ? 0.0 : std::ranges::max(luminances);
  if (brightest <= 0.0) return {0.0};
  double middle = median(luminances);
  if (middle <= 0.0) {
    std::erase_if(luminances, [](double luminance) { return luminance <= 0.0; });
    middle = median(luminances);
  }
  const double first = std::log2(linearOfBright() / brightest);
  const double last = std::log2(linearOfBright() / middle);
  const int count = std::max(2, static_cast<int>(std::ceil(last - first)));
  std::vector<double> exposures;
  for (int step = 0; step < count; ++step) exposures.push_back(first + step * (last - first) / (count - 1));
  return exposures;
}

Image hdrFlipMap(const Image& picture, const Image& reference, const Progress& progress) {
  Image largest(reference.width, reference.height, 1);
  const std::vector<double> exposures = flipExposures(reference);
  int done = 0;
  for (const double exposure : exposures) {
    report(progress, say<"HDR-FLIP">(), done++, static_cast<int>(exposures.size()));
    const Image map = flipMap(toneMapped(picture, exposure), toneMapped(reference, exposure));
    for (std::size_t at = 0; at < map.pixels.size(); ++at)
      largest.pixels[at] = std::max(largest.pixels[at], map.pixels[at]);
  }
  return largest;
}

} // namespace taa
