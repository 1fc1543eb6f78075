#include "core/measure/compare/Ssim.h"

#include "core/measure/compare/Plane.h"

#include <cassert>
#include <cmath>
#include <cstddef>

namespace taa {

namespace {

constexpr double kSsimSigma = 1.5;
constexpr float kSsimC1 = 0.01f * 0.01f,
                kSsimC2 = 0.03f * 0.03f; // (K · 1)², 1 being the range of what is shown

FilterWeights ssimWindow() {
  FilterWeights weights;
  double sum = 0.0;
  const auto bell = [](int x) { return std::exp(-x * x / (2.0 * kSsimSigma * kSsimSigma)); };
  for (int x = -kSsimReach; x <= kSsimReach; ++x) sum += bell(x);
  for (int x = -kSsimReach; x <= kSsimReach; ++x) weights.push_back(static_cast<float>(bell(x) / sum));
  return weights;
}

Plane product(const Plane& a, const Plane& b) {
  Plane out = a;
  for (std::size_t at = 0; at < out.values.size(); ++at) out.values[at] *= b.values[at];
  return out;
}

} // namespace

Image ssimMap(const Image& shown, const Image& reference) {
  assert(shown.width == reference.width && shown.height == reference.height && !shown.empty());
  const FilterWeights window = ssimWindow();
  const Plane x = lumaOf(shown), y = lumaOf(reference);
  const Plane meanX = filtered(x, window), meanY = filtered(y, window);
  const Plane squareX = filtered(product(x, x), window), squareY = filtered(product(y, y), window);
  Plane map = filtered(product(x, y), window);
  for (std::size_t at = 0; at < map.values.size(); ++at) {
    const float mx = meanX.values[at], my = meanY.values[at];
    const float varianceX = squareX.values[at] - mx * mx, varianceY = squareY.values[at] - my * my;
    const float covariance = map.values[at] - mx * my;
    map.values[at] = (2.0f * mx * my + kSsimC1) * (2.0f * covariance + kSsimC2) /
                     ((mx * mx + my * my + kSsimC1) * (varianceX + varianceY + kSsimC2));
  }
  return imageOf(map);
}

double meanSsim(const Image& map) {
  const bool isWhole = map.width > 2 * kSsimReach && map.height > 2 * kSsimReach;
  const int margin = isWhole ? kSsimReach : 0;
  double sum = 0.0;
  for (int y = margin; y < map.height - margin; ++y)
    for (int x = margin; x < map.width - margin; ++x) sum += double(*map.at(x, y));
  return sum / (double(map.width - 2 * margin) * double(map.height - 2 * margin));
}

} // namespace taa
