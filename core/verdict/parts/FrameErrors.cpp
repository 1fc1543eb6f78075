#include "core/verdict/parts/FrameErrors.h"

#include "core/probe/SurfaceSteps.h"
#include "core/taa/twin/HistoryTaps.h"

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace taa {

namespace {

constexpr float kSamePlacePx = 0.5f; // along an axis: within the pixel

glm::vec3 pixelColor(const Image& image, int x, int y) {
  const float* value = image.nearest(x, y);
  return {value[0], value[1], value[2]};
}

glm::vec3 pixelColor(const twin::Texels& texels, int x, int y) {
  return texels.nearestTexel(x, y);
}

void setPixelColor(Image& image, int x, int y, const glm::vec3& color) {
  for (int channel = 0; channel < 3; ++channel) image.at(x, y)[channel] = color[channel];
}

template <typename Picture>
glm::vec3 bilinearColor(const Picture& image, const twin::AxisPlace& x, const twin::AxisPlace& y) {
  const auto row = [&](int at) {
    const glm::vec3 left = pixelColor(image, x.texel, at);
    return x.fraction == 0.0f ? left : left + x.fraction * (pixelColor(image, x.texel + 1, at) - left);
  };
  const glm::vec3 upper = row(y.texel);
  return y.fraction == 0.0f ? upper : upper + y.fraction * (row(y.texel + 1) - upper);
}

/// What of an isolated dot is seen along an axis.
struct SeenOfDot {
  float nearest, bilinear; ///< shares of its height
  explicit SeenOfDot(float fraction)
      : nearest(std::max(fraction, 1.0f - fraction)),
        bilinear(nearest * nearest + (1.0f - nearest) * (1.0f - nearest)) {}
};

template <typename Picture>
glm::vec3 nearestFormerColor(const Picture& before, const glm::vec2& placePx, const glm::vec3& now) {
  const twin::AxisPlace x = twin::axisPlace(placePx.x), y = twin::axisPlace(placePx.y);
  const glm::vec3 middle = bilinearColor(before, x, y);
  const SeenOfDot seenX(x.fraction), seenY(y.fraction);
  const float ranges = (1.0f - seenX.bilinear * seenY.bilinear) / (seenX.nearest * seenY.nearest);
  if (ranges == 0.0f) return middle;
  glm::vec3 low = middle, high = middle;
  for (int k = 0; k < 16; ++k) {
    const glm::vec3 texel = pixelColor(before, x.texel - 1 + k % 4, y.texel - 1 + k / 4);
    low = glm::min(low, texel);
    high = glm::max(high, texel);
  }
  const glm::vec3 reach = ranges * (high - low);
  return glm::clamp(now, middle - reach, middle + reach);
}

glm::vec3 summedColor(const Image& image, const twin::HistoryTexels& texels) {
  glm::vec3 sum(0.0f);
  for (const auto& texel : texels.all()) sum += texel.weight * pixelColor(image, texel.at.x, texel.at.y);
  return sum;
}

glm::vec3 alphaOf(const Image& alpha, int x, int y) {
  const float* value = alpha.at(x, y);
  return alpha.channels == 1 ? glm::vec3(value[0]) : glm::vec3(value[0], value[1], value[2]);
}

void addHistory(FrameErrors& errors, const PartsInputs& now, const Image& before,
                const HistorySettings& settings, const glm::ivec2& pixel) {
  const int x = pixel.x, y = pixel.y;
  const glm::vec3 kept = 1.0f - glm::min(alphaOf(now.alpha, x, y), 1.0f);
  for (int channel = 0; channel < errors.kept.channels; ++channel)
    errors.kept.at(x, y)[channel] = kept[channel];
  if (kept == glm::vec3(0.0f)) return;
  const float* position = now.historyPosition.at(x, y);
  const glm::vec2 read = twin::readPosition({position[0], position[1]}, pixel);
  const bool isOneTap = *now.depthEdge.at(x, y) != 0.0f;
  const float* step = now.steps.at(x, y);
  const bool isOther = isOfOtherSurface(step, read, pixel);
  const HistoryReading how = isOneTap ? HistoryReading::OneTap : HistoryReading::Filtered;
  const float history[] = {read.x, read.y, static_cast<float>(how), isOther ? 1.0f : 0.0f};
  std::copy_n(history, 4, errors.history.at(x, y));
  const glm::vec3 reference = pixelColor(now.reference, x, y);
  const glm::vec3 sum =
      summedColor(before, twin::historyTexels(settings, read, {before.width, before.height}, isOneTap));
  const glm::vec3 former =
      isOther ? reference
              : formerColor(before, glm::vec2(pixel) + 0.5f - glm::vec2(step[0], step[1]), reference);
  setPixelColor(errors.resampled, x, y, kept * (sum - former));
  setPixelColor(errors.lag, x, y, kept * (former - reference));
}

} // namespace

bool isOfOtherSurface(const float* step, const glm::vec2& positionPx, const glm::ivec2& pixel) {
  if (std::isnan(step[0]) || hasFlag(step[3], StepFlag::SeenBeside)) return true;
  const glm::vec2 off = glm::abs(positionPx - (glm::vec2(pixel) + 0.5f - glm::vec2(step[0], step[1])));
  return !(std::max(off.x, off.y) <= kSamePlacePx);
}

glm::vec3 formerColor(const Image& before, const glm::vec2& placePx, const glm::vec3& now) {
  return nearestFormerColor(before, placePx, now);
}

glm::vec3 formerColor(const twin::Texels& before, const glm::vec2& placePx, const glm::vec3& now) {
  return nearestFormerColor(before, placePx, now);
}

FrameErrors frameErrors(const PartsInputs& now, const Image* before, const HistorySettings& settings) {
  const int width = now.resolved.width, height = now.resolved.height;
  assert(now.reference.width == width && now.current.width == width && now.reference.height == height);
  const Image color(width, height, 3);
  FrameErrors errors{color, color, {}, {}, {}, {}};
  if (before) {
    errors.resampled = errors.lag = color;
    errors.kept = Image(width, height, now.alpha.channels);
    errors.history = Image(width, height, 4);
  }
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const glm::vec3 reference = pixelColor(now.reference, x, y);
      const glm::vec3 error = pixelColor(now.resolved, x, y) - reference;
      setPixelColor(errors.error, x, y, error);
      const glm::vec3 alpha = before ? alphaOf(now.alpha, x, y) : glm::vec3(1.0f);
      glm::vec3 aliasing = alpha * (pixelColor(now.current, x, y) - reference);
      for (int channel = 0; channel < 3; ++channel)
        if (alpha[channel] >= 1.0f) aliasing[channel] = error[channel];
      setPixelColor(errors.aliasing, x, y, aliasing);
      if (before) addHistory(errors, now, *before, settings, {x, y});
    }
  return errors;
}

} // namespace taa
