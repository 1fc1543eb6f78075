#include "core/doctor/depth/DepthForm.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace taa::doctor {

namespace {

constexpr std::size_t kEnoughRows = 60;
constexpr double kAgreed = 0.8;
/// Pixels between the three; of the smaller side of the picture, and at least.
constexpr int kGapShare = 24, kLeastGap = 3;
/// Of the step from the first to the third: what is even, and what is clearly not.
constexpr double kEvenRow = 0.25, kLeastUneven = 1e-3;
/// Of the value: a smaller step says nothing, nor what is no more than rounding.
constexpr double kLeastStep = 1e-3;

/// How far the middle one is from halfway between the others, over the step from one to the other.
double unevenness(double first, double middle, double last) {
  const double step = std::abs(last - first);
  return step > 0.0 ? std::abs(first - 2.0 * middle + last) / step : 1e9;
}

/// Whether a pixel has the very value of one beside it along a row: of texels that several pixels share the
/// middle one of three lies off the middle, which makes even what is not.
bool sharesTexel(const Image& depth, const glm::ivec2& pixel, const glm::ivec2& direction) {
  const float value = *depth.at(pixel.x, pixel.y);
  const glm::ivec2 before = pixel - direction, after = pixel + direction;
  return *depth.at(before.x, before.y) == value || *depth.at(after.x, after.y) == value;
}

} // namespace

void DepthForm::add(const DoctorFrame& frame, const std::vector<RegionIndex>& labels) {
  if (frame.depth.empty()) return;
  const glm::ivec2 size = frame.sizePx();
  const int gap = std::max(kLeastGap, std::min(size.x, size.y) / kGapShare);
  const auto count = [&](const glm::ivec2& middle, const glm::ivec2& step) {
    double values[3];
    for (int i = 0; i < 3; ++i) {
      const glm::ivec2 at = middle + (i - 1) * step;
      const auto index = static_cast<std::size_t>(at.y) * size.x + at.x;
      if (labels[index] != labels[static_cast<std::size_t>(middle.y) * size.x + middle.x]) return;
      values[i] = static_cast<double>(frame.depth.pixels[index]);
      if (!(values[i] > 0.0) || values[i] >= 1.0) return; // the sky, or beyond the unit of a distance
    }
    if (std::abs(values[2] - values[0]) < kLeastStep * values[1]) return;
    if (sharesTexel(frame.depth, middle, step / gap)) return;
    const double stored = unevenness(values[0], values[1], values[2]);
    const double reciprocal = unevenness(1.0 / values[0], 1.0 / values[1], 1.0 / values[2]);
    if (std::max(stored, reciprocal) < kLeastUneven) return;
    if (stored <= kEvenRow * reciprocal) ++even;
    if (reciprocal <= kEvenRow * stored) ++evenReciprocal;
  };
  for (int y = gap; y + gap < size.y; y += gap)
    for (int x = gap; x + gap < size.x; x += gap) {
      if (labels[static_cast<std::size_t>(y) * size.x + x] == kNoRegion) continue;
      count({x, y}, {gap, 0});
      count({x, y}, {0, gap});
    }
}

double DepthForm::distanceShare() const {
  return rows() == 0 ? 0.0 : static_cast<double>(evenReciprocal) / static_cast<double>(rows());
}

std::optional<bool> DepthForm::isDistance() const {
  if (rows() < kEnoughRows) return {};
  const double share = distanceShare();
  if (share >= kAgreed) return true;
  if (share <= 1.0 - kAgreed) return false;
  return {};
}

} // namespace taa::doctor
