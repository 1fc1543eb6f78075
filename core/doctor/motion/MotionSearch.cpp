#include "core/doctor/motion/MotionSearch.h"

#include "core/capture/import/FrameSamples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace taa::doctor {

namespace {

constexpr std::size_t kLeastSearched = 24;
constexpr std::size_t kRoughPixels = 128; ///< that are looked at for each whole pixel

/// Infinite where a place lies outside.
double meanDifference(const std::vector<SearchedPixel>& pixels, const Image& luma, const glm::vec2& motionPx,
                      std::size_t step) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < pixels.size(); i += step, ++count) {
    const glm::vec2 place = pixels[i].place - motionPx;
    if (!(place.x >= 0.5f && place.y >= 0.5f && place.x <= static_cast<float>(luma.width) - 0.5f &&
          place.y <= static_cast<float>(luma.height) - 0.5f))
      return std::numeric_limits<double>::infinity();
    sum += static_cast<double>(std::abs(pixels[i].luma - capture::betweenPixels(luma, place)));
  }
  return sum / static_cast<double>(count);
}

struct SearchState {
  glm::vec2 motionPx{0.0f};
  double difference = std::numeric_limits<double>::infinity();
};

} // namespace

std::optional<glm::vec2> searchMotion(const std::vector<SearchedPixel>& pixels, const Image& previousLuma,
                                      const glm::vec2& aroundPx, int reachPx) {
  if (pixels.size() < kLeastSearched) return {};
  SearchState best;
  const auto tryAt = [&](const glm::vec2& motionPx, std::size_t step) {
    const double difference = meanDifference(pixels, previousLuma, motionPx, step);
    if (difference < best.difference) best = {motionPx, difference};
  };
  const std::size_t step = std::max<std::size_t>(1, pixels.size() / kRoughPixels);
  for (int y = -reachPx; y <= reachPx; ++y)
    for (int x = -reachPx; x <= reachPx; ++x) tryAt(aroundPx + glm::vec2(x, y), step);
  if (!std::isfinite(best.difference)) return {};
  best.difference = meanDifference(pixels, previousLuma, best.motionPx, 1);
  for (float stride = 0.5f; stride >= 0.125f; stride *= 0.5f) {
    const glm::vec2 center = best.motionPx;
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) tryAt(center + stride * glm::vec2(x, y), 1);
  }
  if (!std::isfinite(best.difference)) return {};
  return best.motionPx;
}

} // namespace taa::doctor
