#include "core/measure/Flicker.h"

#include "core/base/Say.h"
#include "core/probe/SurfaceSteps.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace taa {

namespace {

glm::dvec3 texel(const Image& image, int x, int y) {
  const float* value = image.nearest(x, y);
  return {value[0], value[1], value[2]};
}

// Texels of no weight are not read: at the center of a pixel it is exactly its value.
glm::dvec3 colorBetween(const Image& image, const glm::dvec2& positionPx) {
  const glm::dvec2 place = positionPx - 0.5, corner = glm::floor(place), part = place - corner;
  const auto x = static_cast<int>(corner.x), y = static_cast<int>(corner.y);
  const auto row = [&](int at) {
    glm::dvec3 value = (1.0 - part.x) * texel(image, x, at);
    if (part.x > 0.0) value += part.x * texel(image, x + 1, at);
    return value;
  };
  glm::dvec3 value = (1.0 - part.y) * row(y);
  if (part.y > 0.0) value += part.y * row(y + 1);
  return value;
}

/// Sums of values less the first of them: where all are the same, all are exactly 0.
class ColorVariance {
 public:
  void add(const glm::dvec3& value) {
    if (count_++ == 0) first_ = value;
    const glm::dvec3 difference = value - first_;
    sum_ += difference;
    squares_ += difference * difference;
  }
  int count() const { return count_; }
  /// Mean of the three variances.
  double variance() const {
    const glm::dvec3 mean = sum_ / double(count_), variances = squares_ / double(count_) - mean * mean;
    return std::max(0.0, (variances.x + variances.y + variances.z) / 3.0);
  }

 private:
  int count_ = 0;
  glm::dvec3 first_{0.0}, sum_{0.0}, squares_{0.0};
};

struct FollowedPixel {
  ColorVariance shown, reference;
};

FollowedPixel follow(std::span<const FlickerFrame* const> newestFirst, int x, int y, bool isCompared) {
  FollowedPixel pixel;
  glm::dvec2 position(x + 0.5, y + 0.5);
  for (std::size_t index = 0;; ++index) {
    const FlickerFrame& frame = *newestFirst[index];
    pixel.shown.add(colorBetween(frame.shown, position));
    if (isCompared) pixel.reference.add(colorBetween(frame.reference, position));
    if (index + 1 == newestFirst.size()) return pixel;
    const float object = newestFirst.front()->steps.at(x, y)[2];
    const std::optional<glm::dvec2> step = stepAt(frame.steps, position, object);
    if (!step) return pixel;
    position -= *step;
    if (position.x < 0.0 || position.y < 0.0 || position.x >= frame.shown.width ||
        position.y >= frame.shown.height)
      return pixel;
  }
}

} // namespace

FlickerMaps flickerMaps(std::span<const FlickerFrame* const> newestFirst, const Progress& progress) {
  assert(!newestFirst.empty());
  const int width = newestFirst.front()->shown.width, height = newestFirst.front()->shown.height;
  const bool isCompared =
      std::ranges::all_of(newestFirst, [](const FlickerFrame* frame) { return frame->referenceSamples > 0; });
  FlickerMaps maps{Image(width, height, 1), {}, Image(width, height, 1)};
  if (isCompared) maps.flicker = Image(width, height, 1);
  for (int y = 0; y < height; ++y) {
    report(progress, say<"Flicker">(), y, height);
    for (int x = 0; x < width; ++x) {
      const FollowedPixel pixel = follow(newestFirst, x, y, isCompared);
      const double variance = pixel.shown.variance();
      *maps.deviation.at(x, y) = static_cast<float>(std::sqrt(variance));
      *maps.frames.at(x, y) = static_cast<float>(pixel.shown.count());
      if (isCompared)
        *maps.flicker.at(x, y) =
            static_cast<float>(std::sqrt(std::max(0.0, variance - pixel.reference.variance())));
    }
  }
  return maps;
}

std::optional<double> meanOverTime(const Image& map, const Image& frames) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t pixel = 0; pixel < map.pixels.size(); ++pixel) {
    if (frames.pixels[pixel] < 2.0f) continue;
    sum += static_cast<double>(map.pixels[pixel]);
    ++count;
  }
  if (count == 0) return {};
  return sum / static_cast<double>(count);
}

} // namespace taa
